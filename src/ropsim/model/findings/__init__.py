"""Kinds of findings on models of robots, and the subject of each finding."""
