"""How deep each line of a text stands in blocks."""

from collections.abc import Iterable, Iterator

from ropsim.language.block_ends import ANY, closed, middle, opened
from ropsim.language.text import Line


def indented(lines: Iterable[Line]) -> Iterator[tuple[Line, int]]:
    """Yield each line with the number of blocks in which it stands; openers and closers stand outside."""
    stack: list[str] = []
    for line in lines:
        opener, closer = opened(line), closed(line)
        if opener == "task":
            stack.clear()
        if opener:
            yield line, len(stack)
            stack.append(opener)
            continue
        if closer == ANY and stack:
            stack.pop()
        elif closer in stack:
            del stack[_last(stack, closer) :]
        elif openers := [word for word in middle(line) if word in stack]:
            del stack[max(_last(stack, word) for word in openers) + 1 :]
            yield line, len(stack) - 1
            continue
        yield line, len(stack)


def _last(stack: list[str], word: str) -> int:
    return len(stack) - 1 - stack[::-1].index(word)
