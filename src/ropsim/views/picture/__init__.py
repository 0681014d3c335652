"""A still picture of a robot as PNG: its shapes drawn into a depth buffer, without any other program."""
