"""A robot as joints of one freedom, and losses of the formats."""
