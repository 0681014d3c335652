"""Commands that serve until they are ended: the studio and the language server."""
