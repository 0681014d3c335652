"""Terms of a knowledge base: expressions, clauses, points, calls and tasks, and their words."""
