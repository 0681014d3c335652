"""Checked text to ICR: each procedure, each part of the main program, and their addresses."""
