"""The rows of PLY elements: columns of numbers, and lists."""

from dataclasses import field

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.meshes.formats.ply_header import Element
from ropsim.meshes.formats.ply_source import Column, Source
from ropsim.meshes.formats.soup import Indices, MeshFileError, check_count, damaged


@frozen_dataclass
class Lists:
    """A column of lists: all entries one after the other, and where each list begins and how long it is."""

    entries: Column
    starts: Indices
    lengths: Indices


@frozen_dataclass
class Rows:
    """The columns of an element by name; of two with the same name the first."""

    count: int
    numbers: dict[str, Column] = field(default_factory=dict)
    lists: dict[str, Lists] = field(default_factory=dict)


def read_rows(source: Source, element: Element) -> Rows:
    """Take the rows of an element.

    Nearly always lists have the same length in all rows: then they are a table, and are read at once.

    Raises:
        MeshFileError: fewer rows are left than the element promises, or more lists than can be drawn.
    """
    if not any(one.length for one in element.properties):
        columns = source.table([(one.number, 1) for one in element.properties], element.count)
        rows = Rows(element.count)
        for one, column in zip(element.properties, columns, strict=True):
            rows.numbers.setdefault(one.name, column[:, 0])
        return rows
    check_count(element.count)
    if not element.count:
        return Rows(0)
    start = source.place()
    lengths = _lengths_of_row(source, element)
    source.go(start)
    return _even(source, element, lengths) or _uneven(source, element, start)


def _lengths_of_row(source: Source, element: Element) -> list[int]:
    """Pass a row and return the lengths of its lists, 1 for a single number."""
    found = []
    for one in element.properties:
        length = _length(source.scalar(one.length)) if one.length else 1
        source.block(one.number, length)
        found.append(length)
    return found


def _even(source: Source, element: Element, lengths: list[int]) -> Rows | None:
    """Take rows whose lists have these lengths; None where one has another."""
    kinds: list[tuple[str, int]] = []
    for one, length in zip(element.properties, lengths, strict=True):
        kinds += [(one.length, 1)] if one.length else []
        kinds.append((one.number, length))
    try:
        columns = iter(source.table(kinds, element.count))
    except MeshFileError:  # lists of this length exceed the rest
        return None
    rows = Rows(element.count)
    for one, length in zip(element.properties, lengths, strict=True):
        if one.length and not (next(columns) == length).all():
            return None
        column = next(columns)
        if one.length:
            starts = np.arange(element.count) * length
            same = np.full(element.count, length)
            rows.lists.setdefault(one.name, Lists(column.reshape(-1), starts, same))
        else:
            rows.numbers.setdefault(one.name, column[:, 0])
    return rows


def _uneven(source: Source, element: Element, start: int) -> Rows:
    source.go(start)
    blocks: list[list[Column]] = [[] for _ in element.properties]
    for _ in range(element.count):
        for one, taken in zip(element.properties, blocks, strict=True):
            length = _length(source.scalar(one.length)) if one.length else 1
            taken.append(source.block(one.number, length))
    rows = Rows(element.count)
    for one, taken in zip(element.properties, blocks, strict=True):
        entries = np.concatenate(taken)
        if one.length:
            lengths = np.array([len(block) for block in taken], dtype=np.int64)
            rows.lists.setdefault(one.name, Lists(entries, np.cumsum(lengths) - lengths, lengths))
        else:
            rows.numbers.setdefault(one.name, entries)
    return rows


def _length(value: float) -> int:
    if not (0 <= value < 2**32 and value == int(value)):
        raise damaged(f"has a list of length {value:g}")
    return int(value)
