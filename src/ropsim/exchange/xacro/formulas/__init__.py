"""Expressions of xacro: values, words, grammar, functions and methods."""
