"""Robots by name or file, in all formats that are read."""
