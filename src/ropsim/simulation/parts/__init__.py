"""Parts of a cell: their poses and supports."""
