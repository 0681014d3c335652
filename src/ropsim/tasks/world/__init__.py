"""The state of a cell as facts, lists of points, and what its geometry tells."""
