"""Built-in entities by name: a file each, their table, and the chain of a station that is made with them."""
