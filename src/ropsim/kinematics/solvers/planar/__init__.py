"""Planar arms, SCARA arms, and arms whose wrist stays level."""
