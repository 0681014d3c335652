"""Points of arms with fewer than six axes: where the TCP is counts, the orientation of the tool follows."""
