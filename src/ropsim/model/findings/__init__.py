"""Kinds of findings on models of robots, and what each finding is about."""
