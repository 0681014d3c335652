"""Completion and signature help: what can be written at a place of a program."""
