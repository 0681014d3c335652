"""Modules in Python of a project, which make entities of the controller."""
