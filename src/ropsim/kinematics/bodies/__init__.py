"""Poses of all bodies of a cell, rays, ground, and supports of parts."""
