"""Examples in the manuals: fenced blocks of a page, each with the line where it stands."""

import re
from dataclasses import dataclass
from pathlib import Path

DOCS = Path(__file__).parents[2] / "docs"

_FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True, slots=True)
class Block:
    """One fenced block.

    Attributes:
        page: name of the file.
        line: of the page where its text begins.
        text: what stands between the fences.
    """

    page: str
    line: int
    text: str

    def __str__(self) -> str:
        return f"{self.page}:{self.line}"

    @property
    def lines(self) -> list[str]:
        """Return the lines of the text."""
        return self.text.splitlines()


def blocks(page: Path, language: str) -> list[Block]:
    """Return the blocks of one language on a page; there must be some."""
    text = page.read_text("utf-8")
    found = [
        Block(page.name, text.count("\n", 0, match.start(2)) + 1, match[2])
        for match in _FENCE.finditer(text)
        if match[1] == language
    ]
    assert found, f"{page} has no `{language}` block"
    return found
