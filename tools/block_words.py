"""Write the words of blocks of the task language for the editor of the page, from the tables of the language.

python tools/block_words.py           write the file
python tools/block_words.py --check   compare only; exit 1 where it differs
"""

import sys
from collections.abc import Iterator
from pathlib import Path

from ropsim.language import DIVIDERS, HEADS, OPENERS

FILE = Path(__file__).parent.parent / "frontend" / "src" / "editor" / "block_words.ts"


def text() -> str:
    """Return the text of the file."""
    return "\n".join(_lines()) + "\n"


def _lines() -> Iterator[str]:
    yield "/** Words of blocks of the task language, as `tools/block_words.py` takes them from it. */"
    yield ""
    yield "/** The opener of the block that a word closes. */"
    yield "export const CLOSERS: Readonly<Record<string, string>> = {"
    yield from (f"  {word}: '{opener}'," for opener, words in OPENERS.items() for word in words)
    yield "}"
    yield ""
    yield "/** The openers of the blocks that a word may divide. */"
    yield "export const DIVIDERS: Readonly<Record<string, readonly string[]>> = {"
    for word, openers in DIVIDERS.items():
        quoted = ", ".join(f"'{one}'" for one in openers)
        yield f"  {word}: [{quoted}],"
    yield "}"
    yield ""
    yield "/** Words that start a statement: no line that begins with one goes on the line before. */"
    yield "export const HEADS: ReadonlySet<string> = new Set(["
    yield from (f"  '{word}'," for word in sorted(HEADS))
    yield "])"


def main(arguments: list[str]) -> int:
    """Write or check the file; return the exit code."""
    if not FILE.parent.is_dir():
        print("no sources of pages here: an sdist carries them built")
        return 0
    if arguments == ["--check"]:
        is_stale = not FILE.is_file() or FILE.read_text("utf-8") != text()
        if is_stale:
            print(f"stale: {FILE.name}; run python tools/block_words.py")
        return int(is_stale)
    FILE.write_text(text(), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
