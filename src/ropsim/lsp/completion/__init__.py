"""Completion and signature help: words and values at a place of a program."""
