"""Names of a file as messages show them."""

from collections.abc import Iterable

NAMED = 6
"""Number of entities named in a message."""


def shown(text: str) -> str:
    """Return a text of the file in the form quoted in a message: on one line, and not too long."""
    line = " ".join(text.split())
    return line if len(line) <= 60 else line[:57] + "..."


def listed(names: Iterable[str], most: int = NAMED) -> str:
    """Return names in words: the first few, and how many more."""
    unique = list(dict.fromkeys(names))
    words = ", ".join(f"`{shown(name)}`" for name in unique[:most])
    return words + (f" and {len(unique) - most} more" if len(unique) > most else "")
