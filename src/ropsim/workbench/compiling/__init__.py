"""Programs of a station compiled in its cell, and what dry runs of them give."""
