"""Builders of diagrams: a function for each kind of joint controller."""
