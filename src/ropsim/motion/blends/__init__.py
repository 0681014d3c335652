"""Blends between paths of the tool: where a zone is left and entered, and the curve between."""
