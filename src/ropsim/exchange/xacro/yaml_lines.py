"""Lines of a YAML text without comments; brackets over several lines become one line."""

from ropsim.exchange.xacro.formulas.values import LONGEST, XacroError

MOST_LINES = 5_000

Line = tuple[int, str]
"""Indentation, and the text behind it."""


def yaml_lines(text: str) -> list[Line]:
    """Return the lines that are not empty.

    Raises:
        XacroError: they are too many, indented by tabulators, or a bracket or quotation mark stays open.
    """
    found: list[Line] = []
    joined, indent, level = "", 0, 0
    for line in text.splitlines():
        bare, opened = _bare(line)
        stripped = bare.strip()
        if not stripped or (not level and stripped in ("---", "...")) or bare.startswith("%"):
            continue
        if len(found) >= MOST_LINES or "\t" in bare[: len(bare) - len(bare.lstrip())]:
            raise XacroError("a YAML file is too long, or indented by tabulators", "use blanks")
        if not level:
            indent, joined = len(bare) - len(bare.lstrip()), stripped
        else:
            joined += " " + stripped
        level = max(level + opened, 0)
        if len(joined) > LONGEST:
            raise XacroError("a YAML file has brackets that are too long", "make them shorter")
        if not level:
            found.append((indent, joined))
    if level:
        raise XacroError(f"a bracket of a YAML file is not closed in `{joined[:40]}`", "close it")
    return found


def _bare(line: str) -> tuple[str, int]:
    """Return a line without its comment, and how many more brackets it opens than it closes."""
    quote, level = "", 0
    before = ""  # last letter that is no blank
    for place, letter in enumerate(line):
        begins = before in ("", ":", "-", ",", "[", "{") or level > 0
        if quote:
            quote = "" if letter == quote else quote
        elif letter in "'\"" and begins:
            quote = letter
        elif letter == "#" and (place == 0 or line[place - 1].isspace()):
            return line[:place].rstrip(), level
        elif letter in "[{" and begins:
            level += 1
        elif letter in "]}":
            level -= 1
        before = before if letter.isspace() else letter
    return line.rstrip(), level
