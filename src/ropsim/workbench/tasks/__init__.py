"""Texts of tasks that programs can call, and the Prolog engine that compiles them."""
