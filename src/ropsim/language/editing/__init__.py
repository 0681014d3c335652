"""Answers for editors: outline, uses of names, colours, written locations and words by place."""
