"""Scene of a cell: bodies with shapes, frames."""
