"""Forces between bodies that are pressed on each other, from their surfaces and depths."""
