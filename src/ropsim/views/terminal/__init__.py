"""Text for a terminal: summaries, diagnostics with source lines, aligned columns."""
