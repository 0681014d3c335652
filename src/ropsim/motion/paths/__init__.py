"""Paths of the tool over their own length, and sections of them."""
