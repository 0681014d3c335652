"""Whether a call is possible, its missing conditions, and plans for a goal."""
