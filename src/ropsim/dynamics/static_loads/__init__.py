"""Efforts of gravity and springs at the axes: in given postures, and the greatest of all postures."""
