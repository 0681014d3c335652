"""Parts of a cell: where they are, and on what they stand."""
