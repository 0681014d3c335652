"""Solutions of inverse kinematics: their records, selection within limits, and polishing."""
