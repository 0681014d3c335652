"""One move: its path, and the path-following inverse kinematics."""
