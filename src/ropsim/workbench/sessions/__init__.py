"""A robot that carries out one command after the other."""
