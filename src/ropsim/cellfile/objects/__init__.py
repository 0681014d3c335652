"""Fixed objects, parts and their supports and destinations."""
