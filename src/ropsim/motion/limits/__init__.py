"""Limits of joints on a planned motion: where they bind, and the slowing that keeps them."""
