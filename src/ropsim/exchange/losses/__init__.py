"""Kinds of findings, and notes on losses of a file or a format."""
