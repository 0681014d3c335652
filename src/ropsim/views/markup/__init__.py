"""Pieces of HTML and SVG, their colours, axis ticks and thinned points."""
