"""Calls: signatures of tasks, explicit and implicit parameters, and their arguments."""
