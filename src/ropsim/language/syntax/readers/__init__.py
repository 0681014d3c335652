"""Readers of statements: one file for each kind of line, and the table by first words."""
