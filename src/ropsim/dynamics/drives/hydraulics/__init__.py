"""Hydraulic motors, vanes and cylinders, and the servo valves that they are at."""
