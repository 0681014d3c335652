"""Data of the server about documents: compiled texts, names in scope, types, and recorded runs."""
