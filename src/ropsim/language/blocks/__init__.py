"""Lines to blocks: matched openers and closers, contract clauses, misspelt words, and the units of a text."""
