"""Arms with a spherical wrist, or with a sliding joint before the wrist."""
