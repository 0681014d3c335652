"""Numbers, events and messages in words for people."""
