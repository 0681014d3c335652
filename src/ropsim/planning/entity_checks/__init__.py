"""Checks of what entities and paths of a user return."""
