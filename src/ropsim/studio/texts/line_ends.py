"""Line ends: pages see line feeds only, files keep theirs byte for byte."""

import re

_END = re.compile(r"\r\n|\r|\n")


def plain_lines(text: str) -> str:
    """Return the text with line feeds for all line ends, and `?` for invalid Unicode."""
    return _END.sub("\n", text).encode("utf-8", "replace").decode("utf-8")


def restored(text: str, former: str) -> str:
    """Return a text with the line ends that it had in a former state.

    Lines before the first and after the last changed line keep theirs, also where they are mixed; lines
    between take the kind that the former text has most.

    Args:
        text: with line feeds only.
        former: with any line ends.
    """
    old, new = _cut(former), _cut(text)
    head = _equal_from_start(old, new)
    tail = _equal_from_start(old[head:][::-1], new[head:][::-1])
    usual = _most_used(former)
    middle = [(line, end and usual) for line, end in new[head : len(new) - tail]]
    kept = [*old[:head], *middle, *old[len(old) - tail :]]
    return "".join(line + end for line, end in _unmerged(kept))


def _unmerged(lines: list[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return lines of which no two became one: a carriage return that now stands before a line feed."""
    found: list[tuple[str, str]] = []
    for line, end in reversed(lines):  # a line that becomes one with the next may do so with the one before
        merges = end == "\r" and bool(found) and found[-1] == ("", "\n")
        found.append((line, "\n" if merges else end))
    return found[::-1]


def _cut(text: str) -> list[tuple[str, str]]:
    """Return the lines, each with its end; the last has no end."""
    lines, ends = _END.split(text), _END.findall(text)
    return list(zip(lines, [*ends, ""], strict=True))


def _equal_from_start(old: list[tuple[str, str]], new: list[tuple[str, str]]) -> int:
    """Return how many lines are the same, up to the kind of their ends."""
    for index, ((line, end), (other, other_end)) in enumerate(zip(old, new, strict=False)):
        if line != other or bool(end) != bool(other_end):
            return index
    return min(len(old), len(new))


def _most_used(text: str) -> str:
    ends = _END.findall(text)
    return max(("\n", "\r\n", "\r"), key=ends.count)
