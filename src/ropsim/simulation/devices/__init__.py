"""Devices of a running cell: their courses over time, and one file for each kind of drive."""
