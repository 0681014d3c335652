"""Limits of joints on a planned trajectory: utilisation, and the slowing that keeps them."""
