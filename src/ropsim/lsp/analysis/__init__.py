"""What the server knows of documents: compiled texts, names in scope, types, and recorded runs."""
