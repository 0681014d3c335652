"""Bodies of tasks: task text to terms and back, and what a body changes."""
