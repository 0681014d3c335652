"""The stack machine: instructions, geometry, its world and its state."""
