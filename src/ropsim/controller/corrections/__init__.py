"""Corrections of a path by a sensor: the shift, its room in the joints, and the shifted references."""
