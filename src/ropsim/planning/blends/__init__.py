"""Blends between moves: of the path of the tool, or of the motion of the joints."""
