"""Poses of all bodies of a cell, rays, ground, and on what parts lie."""
