"""Hover, outline, folding, inlay hints and colours of a document."""
