"""Processes that are killed while they write, at moments that are counted and not measured."""
