"""Texts of projects and everything derived from them, kept until a text changes."""
