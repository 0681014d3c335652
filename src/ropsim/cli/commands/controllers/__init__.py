"""Commands about the joint controller of a cell."""
