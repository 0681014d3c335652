"""A run as columns of numbers for the page: the pack."""
