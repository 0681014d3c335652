"""TOML text: its values, where they stand, and whether they are what is allowed."""
