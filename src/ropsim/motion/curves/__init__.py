"""What paths are made of: their protocols, polynomials, differences, distances and rotation vectors."""
