"""Expressions of xacro: values, words, grammar, and what may be called."""
