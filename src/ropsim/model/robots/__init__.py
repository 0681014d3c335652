"""Robots: Denavit–Hartenberg tables, coupled axes, external axes, payloads, and mechanisms joined to one."""
