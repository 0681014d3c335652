"""Changed lines of a text: found by comparing characters, without splitting the text."""

from ropsim.core.frozen_dataclass import frozen_dataclass

_STEP = 65_536
"""Characters that are compared at a time."""


@frozen_dataclass
class EditedLines:
    """The lines between the unchanged begin and the unchanged end of a text.

    Attributes:
        above: number of unchanged lines above.
        below: number of unchanged lines below.
        between: the lines between them, at least one.
        begin: where these begin in both texts.
        end: where they end.
        end_before: where those end that stood there before.
    """

    above: int
    below: int
    between: list[str]
    begin: int
    end: int
    end_before: int


def edited_lines(before: str, now: str) -> EditedLines:
    """Return the lines that have changed in a text whose lines end with a line feed alone."""
    first = _alike(before, now)
    last = len(now) - _alike_at_end(before, now, min(len(before), len(now)) - first)
    below = now.count("\n", last)
    end = now.find("\n", last) if below else len(now)
    begin = now.rfind("\n", 0, first) + 1
    between = now[begin:end].split("\n")
    return EditedLines(now.count("\n", 0, begin), below, between, begin, end, end - len(now) + len(before))


def _alike(one: str, other: str) -> int:
    """Return with how many equal characters two texts begin."""
    least, low = min(len(one), len(other)), 0
    while low < least and one[low : low + _STEP] == other[low : low + _STEP]:
        low += _STEP
    low, high = min(low, least), min(low + _STEP, least)
    while low < high:
        middle = (low + high + 1) // 2
        if one[low:middle] == other[low:middle]:
            low = middle
        else:
            high = middle - 1
    return low


def _alike_at_end(one: str, other: str, most: int) -> int:
    """Return with how many equal characters two texts end, `most` at most."""
    end, others_end, low = len(one), len(other), 0
    while low < most and _are_alike_at(one, other, end - low, others_end - low, min(_STEP, most - low)):
        low += _STEP
    low, high = min(low, most), min(low + _STEP, most)
    while low < high:
        middle = (low + high + 1) // 2
        if _are_alike_at(one, other, end - low, others_end - low, middle - low):
            low = middle
        else:
            high = middle - 1
    return low


def _are_alike_at(one: str, other: str, end: int, others_end: int, size: int) -> bool:
    return one[end - size : end] == other[others_end - size : others_end]
