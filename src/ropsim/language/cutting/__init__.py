"""A text in chunks that are cut and read again only around an edit."""
