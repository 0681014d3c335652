"""Checks of results of a user's entities and paths."""
