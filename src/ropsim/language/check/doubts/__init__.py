"""Values that are allowed and probably a mistake: wrong unit, tool pointing up, name read once."""
