"""Vector instructions: straight lines of Python for eight rows or eight columns at a time."""
