"""Statements: each kind of line to typed statements, and lines to structured blocks."""
