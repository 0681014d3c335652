"""Conditions of tasks decided by the geometry of a cell, and the knowledge base with its cell."""
