"""Syntax to the structured program: scopes, types, units, poses, one small file per theme."""
