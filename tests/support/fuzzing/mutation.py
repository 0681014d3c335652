"""Changes of bytes, of texts and of plain values, drawn from a generator of numbers that is given."""

import copy
import re
import struct
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import numpy as np

from support.fuzzing.values import DEPTHS, DOUBLES, INTEGERS, NUMBERS, TEXTS, VALUES

_NUMBER = re.compile(rb"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
_WORD = re.compile(rb"[A-Za-z_.]+")
_REFERENCE, _KEYWORD = re.compile(rb"#\d+"), re.compile(rb"(?<==)[A-Z_0-9]+")
_BRACKETS = ((b"[", b"]"), (b"{", b"}"), (b"(", b")"), (b'{"a":', b"}"), (b"[[", b""), (b"if (", b""))
_LARGEST = 150_000  # bytes of a changed input
_PLACES = 3000  # among which one is chosen

Change = Callable[[Random, bytes], bytes]


def mutated(random: Random, content: bytes, changes: Sequence[Change]) -> bytes:
    """Return content after one to four changes, most often after one."""
    for _ in range(random.choice((1, 1, 1, 2, 2, 3, 4))):
        content = random.choice(changes)(random, content)[:_LARGEST]
    return content


def _part(random: Random, content: bytes, longest: int) -> slice:
    start = random.randint(0, len(content))
    return slice(start, min(len(content), start + random.randint(0, longest)))


def _replaced(content: bytes, part: slice, by: bytes) -> bytes:
    return content[: part.start] + by + content[part.stop :]


def flip(random: Random, content: bytes) -> bytes:
    """Change single bits."""
    changed = bytearray(content)
    for _ in range(random.randint(1, 4) if content else 0):
        changed[random.randrange(len(changed))] ^= 1 << random.randrange(8)
    return bytes(changed)


def noise(random: Random, content: bytes) -> bytes:
    """Put random bytes somewhere."""
    return _replaced(content, _part(random, content, 12), random.randbytes(random.randint(0, 12)))


def cut(random: Random, content: bytes) -> bytes:
    """Leave out a part, or everything from some place on."""
    if random.random() < 0.3:
        return content[: random.randint(0, len(content))]
    return _replaced(content, _part(random, content, max(1, len(content) // 4)), b"")


def double(random: Random, content: bytes) -> bytes:
    """Repeat a part, seldom very often."""
    part = _part(random, content, 200)
    return _replaced(content, part, content[part] * random.choice((2, 2, 2, 3, 3, 5, 5, 20, 50, 1000)))


def swap(random: Random, content: bytes) -> bytes:
    """Put one part over another."""
    part = _part(random, content, 40)
    return _replaced(content, _part(random, content, 40), content[part])


def integer(random: Random, content: bytes) -> bytes:
    """Write an integer at the edge of its type over bytes."""
    size, code = random.choice(((1, "B"), (2, "H"), (4, "I"), (4, "I"), (8, "Q")))
    order = random.choice("<<<>")
    value = random.choice(INTEGERS) & (2 ** (8 * size) - 1)
    return _over(random, content, struct.pack(order + code, value), size)


def number(random: Random, content: bytes) -> bytes:
    """Write a wild floating-point number over bytes."""
    value = random.choice(DOUBLES)
    if random.random() < 0.5:
        return _over(random, content, struct.pack("<d", value), 8)
    with np.errstate(over="ignore"):
        return _over(random, content, np.array(value, "<f4").tobytes(), 4)


def _over(random: Random, content: bytes, value: bytes, step: int) -> bytes:
    start = random.randint(0, max(0, len(content) - len(value)))
    if random.random() < 0.5:
        start = start // step * step
    return content[:start] + value + content[start + len(value) :]


def numeral(random: Random, content: bytes) -> bytes:
    """Write another number where a text has one."""
    return _instead(random, content, _NUMBER, random.choice(NUMBERS).encode())


def word(random: Random, content: bytes) -> bytes:
    """Write another word, or something else, where a text has one."""
    words = _WORD.findall(content)
    other = random.choice(TEXTS).encode() if random.random() < 0.5 or not words else random.choice(words)
    return _instead(random, content, _WORD, other)


def _instead(random: Random, content: bytes, pattern: re.Pattern[bytes], by: bytes) -> bytes:
    places = [match.span() for match in pattern.finditer(content[:20_000])]
    if not places:
        return content + by
    start, end = random.choice(places)
    return content[:start] + by + content[end:]


def line(random: Random, content: bytes) -> bytes:
    """Leave out, repeat or move a line."""
    lines = content.split(b"\n")
    one = lines.pop(random.randrange(len(lines)))
    for _ in range(random.choice((0, 1, 1, 2))):
        lines.insert(random.randint(0, len(lines)), one)
    return b"\n".join(lines)


def insert(random: Random, content: bytes) -> bytes:
    """Put a text that breaks readers somewhere."""
    return _replaced(content, _part(random, content, 3), random.choice(TEXTS).encode())


def nest(random: Random, content: bytes) -> bytes:
    """Put brackets around a part, many deep."""
    part = _part(random, content, 20)
    opening, closing = random.choice(_BRACKETS)
    depth = random.choice(DEPTHS[:3] if random.random() < 0.9 else DEPTHS)
    return _replaced(content, part, opening * depth + content[part] + closing * depth)


BYTES: tuple[Change, ...] = (flip, noise, cut, double, swap, integer, number)
TEXT: tuple[Change, ...] = (numeral, numeral, word, word, line, line, insert, nest, cut, double, swap, noise)


def changed_value(random: Random, value: object) -> object:
    """Return a copy of a plain value with one value inside of it changed."""
    whole: list[Any] = [copy.deepcopy(value)]
    holder, key = random.choice(list(_places(whole)))
    choice = random.random()
    if choice < 0.6:
        holder[key] = random.choice(VALUES)
    elif choice < 0.75:
        other_holder, other_key = random.choice(list(_places(whole)))
        holder[key] = copy.deepcopy(other_holder[other_key])
    elif choice < 0.85 and isinstance(holder, dict):
        del holder[key]
    elif choice < 0.95 and isinstance(holder[key], list):
        holder[key] = holder[key] * random.choice((0, 2, 3, 40))
    elif isinstance(holder[key], int) and not isinstance(holder[key], bool):
        holder[key] += random.choice((-1, 1, 2**16))
    else:
        holder[key] = {random.choice(TEXTS): holder[key]}
    return whole[0]


def _places(whole: list[Any]) -> list[tuple[Any, Any]]:
    """Return every holder of a value with the key or the place of that value."""
    found: list[tuple[Any, Any]] = []
    waiting: list[Any] = [whole]
    while waiting and len(found) < _PLACES:
        holder = waiting.pop()
        for key in list(holder) if isinstance(holder, dict) else range(len(holder)):
            found.append((holder, key))
            if isinstance(holder[key], (dict, list)):
                waiting.append(holder[key])
    return found


def damaged_exchange(random: Random, content: bytes, entities: Sequence[bytes], most: int) -> bytes:
    """Return an exchange file after up to three changes, most of which keep its syntax.

    Args:
        random: numbers.
        content: of a right file.
        entities: names that are put in place of others.
        most: largest number that is put in place of one of an instance.
    """
    for _ in range(random.choice((0, 1, 1, 2, 3))):
        choice = random.random()
        if choice < 0.3:
            content = _exchanged(random, content, _REFERENCE, b"#%d" % random.randint(1, most))
        elif choice < 0.5:
            content = _exchanged(random, content, _KEYWORD, random.choice(entities))
        elif choice < 0.8:
            content = numeral(random, content)
        elif choice < 0.9:
            content = word(random, content)
        else:
            content = mutated(random, content, TEXT)
    return content


def _exchanged(random: Random, content: bytes, pattern: re.Pattern[bytes], new: bytes) -> bytes:
    found = list(pattern.finditer(content))
    if not found:
        return content
    one = random.choice(found)
    return content[: one.start()] + new + content[one.end() :]
