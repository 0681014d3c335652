"""Arms with three parallel axes, and redundant arms with a swivel angle."""
