"""Paths on which the tool turns by the angles of the wrist."""
