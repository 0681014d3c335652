"""The state of a cell as facts, lists of points, and conditions of its geometry."""
