"""Printing, progress, watched files and words of numbers for the commands."""
