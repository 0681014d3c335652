"""Live runs: paced by the clock, steered by keys."""
