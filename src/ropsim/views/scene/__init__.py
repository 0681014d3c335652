"""What a cell looks like: bodies with shapes, frames."""
