"""Rows of `drives` that are moved by oil: valves and cylinders."""
