"""Graphic elements: the solids and lines that links, tools and objects are drawn with."""
