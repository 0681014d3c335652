"""A task as a form of fields, and its changes written back to the text."""
