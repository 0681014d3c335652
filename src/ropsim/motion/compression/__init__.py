"""Compression: a run of short straight moves with zones becomes one curve of least jerk within tolerances."""
