"""Time laws with limited jerk: profiles, sections in the least time, synchronised joints."""
