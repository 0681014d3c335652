"""Text to syntax: tokens, logical lines, expressions and statements; independent of the meanings of names."""
