"""The servo loop: compiled slices of controller, drives and arm."""
