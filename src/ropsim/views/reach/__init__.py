"""Workspaces of arms and points of a task, as text and as a page."""
