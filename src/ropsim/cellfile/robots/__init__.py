"""Stations with their robots, external axes, controllers and tools."""
