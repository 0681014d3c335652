"""Names at all their places: definition, references, highlights and renaming."""
