"""From the running state to a recording."""
