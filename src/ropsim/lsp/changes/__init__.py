"""Findings, code actions and formatting: changes of a text that the server offers."""
