"""Hostile input by the hundred or by the hundred thousand: the same targets for tests and for long runs."""
