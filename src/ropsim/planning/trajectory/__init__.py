"""From path segments to a trajectory: sections, their timing, joint coordinates over nominal time."""
