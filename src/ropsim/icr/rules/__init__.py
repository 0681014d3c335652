"""The rules of the verifier."""
