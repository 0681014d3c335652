"""Text of users and of the language as Markdown that shows it as it stands."""

import re

_MARKS = re.compile(r"([\\`*_{}\[\]<>#|&])")


def plain(text: str) -> str:
    """Return text of a user so that Markdown shows it as it stands."""
    return _MARKS.sub(r"\\\1", text)


def code(text: str) -> str:
    """Return text of the task language as a block."""
    fence = "`" * (3 + max((len(run) for run in re.findall(r"`{3,}", text)), default=0))
    return f"{fence}task\n{text}\n{fence}"
