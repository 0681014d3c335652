"""Requests about the cell file: completion, hover, names and sections."""
