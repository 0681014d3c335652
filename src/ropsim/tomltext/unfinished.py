"""Incomplete input at a place of a TOML text: its table and key, and the text without it."""

from collections.abc import Iterable

from ropsim.core import frozen_dataclass
from ropsim.tomltext.open_places import OpenPlaces
from ropsim.tomltext.positions import Path

_CLOSING = {"[": "]", "{": "}"}


@frozen_dataclass
class Unfinished:
    """A place at which something is being written.

    Attributes:
        table: path of the section or inline table around it; None in a list, a remark, a long text.
        key: path of the key whose value, or an item of it, is being written; None for none.
        typed: part of the key, the value or the item before the place.
        others: keys of the table that stand elsewhere.
        rest: the text without the incomplete input; open constructs around it are closed.
    """

    table: Path | None
    key: Path | None
    typed: str
    others: frozenset[str]
    rest: str


def unfinished_at(lines: Iterable[str], row: int, column: int) -> Unfinished:
    """Return the incomplete input at a place; the text need not be TOML, and each line is read once.

    Args:
        lines: of the text, without their ends.
        row: of the place, from 0.
        column: of the place, from 0.
    """
    walk, text = OpenPlaces((row, column)), list[str]()
    below: int | None = None
    for number, line in enumerate(lines):
        text.append(line)
        walk.pass_line(number, line)
        if number > row and below is None and not walk.goes_on:
            below = number
    if not walk.found:  # the place lies behind the text
        text.append("")
        walk.stop = len(text) - 1, 0
        walk.pass_line(len(text) - 1, "")
    opened, lists = walk.found, 0
    while opened[-1].sign == "[":
        opened.pop()
        lists += 1
    table = opened[-1]
    path = (*walk.section_found, *(step for one in opened[:-1] for step in one.steps))
    key = (*path, *table.key) if table.key and lists < 2 and not walk.is_quiet else None
    first, before = table.start
    head = text[first][:before].rstrip().removesuffix(",")
    closing = "".join(_CLOSING[one.sign] for one in reversed(opened[1:]))
    behind = text[below:] if below is not None else []
    return Unfinished(
        None if lists or walk.is_quiet else path,
        key,
        walk.typed,
        frozenset(name for name, start in table.seen if start != table.start),
        "\n".join((*text[:first], head + closing, *behind)),
    )
