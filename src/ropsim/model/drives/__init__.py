"""Drives as chains of blocks: friction, hydraulic motors and cylinders, and the linkages of cylinders."""
