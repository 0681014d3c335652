"""Names, types, units and constants as the checker of one body sees them."""
