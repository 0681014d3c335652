"""Drives as chains of blocks, hydraulic motors and cylinders, and the linkages of cylinders."""
