"""Bodies of tasks: task text to terms and back, and the changes that a body makes."""
