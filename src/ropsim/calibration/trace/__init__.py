"""A logged trace: read from tables, with its rests matched to the stops of the program."""
