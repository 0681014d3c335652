"""Retiming: a trajectory within the limits of the joints, and which of them bind."""
