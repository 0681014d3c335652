"""Text to syntax: tokens, logical lines, expressions and statements; nothing here knows what a name means."""
