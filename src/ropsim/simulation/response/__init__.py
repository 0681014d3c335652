"""Responses of a servo-driven arm to steps, ramps and sines, and stability margins of its loops."""
