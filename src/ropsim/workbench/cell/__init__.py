"""What the geometry of a cell answers about tasks, and the knowledge base with its cell."""
