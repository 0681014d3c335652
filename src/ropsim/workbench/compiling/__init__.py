"""Programs of a station compiled in its cell, and results of their dry runs."""
