"""Kinds of findings, and notes of what a file or a format does not hold."""
