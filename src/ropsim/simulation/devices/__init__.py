"""Devices of a running cell: their motion profiles, and one file for each kind of drive."""
