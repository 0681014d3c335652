"""Kinds of findings on knowledge bases, and the words of their texts."""
