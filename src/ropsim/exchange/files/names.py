"""Names of links and joints in the files that are written; the model calls links after their joints."""

BASE = "base_link"
"""The link that stands still (REP 120, REP 199)."""
FLANGE = "flange"
"""The link that is the mechanical interface (REP 199)."""


def link_name(joint: str) -> str:
    """Return the name of the link that a joint moves."""
    return f"link_{joint}"


def unused(name: str, names: set[str]) -> str:
    """Return a name that is not among others, with as few underscores behind it as that takes."""
    while name in names:
        name += "_"
    return name
