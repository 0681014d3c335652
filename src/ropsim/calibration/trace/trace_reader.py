"""Reading a trace from the bytes of a table, in time and memory that are linear in its size."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.calibration.diagnostics import BAD_TRACE, GAPS, CalibrationError
from ropsim.calibration.trace.columns import Column, columns_of, plain_columns
from ropsim.calibration.trace.trace import Trace
from ropsim.core import Diagnostic, Span
from ropsim.model import Joint
from ropsim.spatial import Array

LARGEST = 200_000_000
"""Largest trace that is read [bytes]: an hour of twelve axes at 500 Hz has half of it."""

_LEAST_ROWS = 20
_MOST_COLUMNS = 1000
_MOST_MISSING = 0.1
_SLOWEST, _QUICKEST = 20.0, 2000.0  # [1/s]
_MOST = 1e4  # [rad | m]
_UNBELIEVABLE = 1e15
"""Numbers beyond this, and NaN, count as missing."""
_ABSENT = frozenset({"", "-", "nan", "na", "n/a", "null", "none", "inf", "-inf", "+inf"})


def read_trace(
    content: bytes, joints: Sequence[Joint], name: str
) -> tuple[Trace | None, tuple[Diagnostic, ...]]:
    """Return the trace in a table, and the findings.

    Args:
        content: of the file; any bytes are allowed.
        joints: of the axes of the robot, n of them.
        name: of the file, for messages.

    Returns:
        The trace, or None where there is an error; and the findings.
    """
    try:
        return _read(content, joints, name)
    except CalibrationError as error:
        return None, (error.diagnostic,)


def _read(content: bytes, joints: Sequence[Joint], name: str) -> tuple[Trace, tuple[Diagnostic, ...]]:
    if len(content) > LARGEST:
        message = f"`{name}` has {len(content) / 1e6:.0f} MB, at most {LARGEST / 1e6:.0f} MB are read"
        raise _error(message, "log fewer columns, or one cycle only", name, 0)
    columns: tuple[Column, ...] = ()
    lines: list[int] = []
    values: list[tuple[float, ...]] = []
    missing, separator = 0, ","
    for line, text in _lines(content, name):
        if not columns:
            separator = next((one for one in ("\t", ";") if one in text), ",")
        cells = text.split(separator, _MOST_COLUMNS + 1)
        if len(cells) > _MOST_COLUMNS:
            raise _error(f"`{name}` has more than {_MOST_COLUMNS} columns", "", name, line)
        if not columns:
            cells = [one.strip().strip('"') for one in cells]
            if any(not _is_number(one, separator) for one in cells):
                columns = columns_of(cells, joints, name, line)
                continue
            columns = plain_columns(len(cells), joints, name, line)
        row = _row(cells, columns, separator, name, line)
        if row is None:
            missing += 1
        else:
            lines.append(line)
            values.append(row)
    if missing > _MOST_MISSING * (missing + len(values)):
        lines_missing = f"{missing} of {missing + len(values)} lines of `{name}`"
        message = f"{lines_missing} lack a value or have a wild one, allowed is a tenth"
        raise _error(message, "log all axes at one rate", name, 0)
    if len(values) < _LEAST_ROWS:
        message = f"`{name}` has {len(values)} samples, needed are {_LEAST_ROWS} at least"
        raise _error(message, "log the whole program", name, 0)
    table = np.array(values) * np.array([one.factor for one in columns])
    _check_times(table[:, 0], lines, name)
    _check_coordinates(table[:, 1:], lines, name)
    findings = (_gaps(missing, len(values), name),) if missing else ()
    return Trace(table[:, 0] - table[0, 0], table[:, 1:]), findings


def _lines(content: bytes, name: str) -> list[tuple[int, str]]:
    """Return the lines that hold something, with their numbers."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        try:
            text = content.decode("utf-16" if content[:2] in (b"\xff\xfe", b"\xfe\xff") else "cp1252")
        except UnicodeDecodeError:
            raise _error(f"`{name}` is no text", "export the trace as CSV", name, 0) from None
    if "\0" in text:
        raise _error(f"`{name}` is no text", "export the trace as CSV", name, 0)
    found = enumerate(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"), start=1)
    return [(number, line) for number, line in found if line.strip() and not line.lstrip().startswith("#")]


def _is_number(cell: str, separator: str) -> bool:
    if cell.lower() in _ABSENT:
        return True
    return _number(cell, separator) is not None


def _number(cell: str, separator: str) -> float | None:
    """Return the number in a cell, NaN where there is none, None where it holds something else."""
    try:
        return float(cell)  # the common case first
    except ValueError:
        pass
    cell = cell.strip().strip('"').strip()
    if cell.lower() in _ABSENT:
        return math.nan
    try:
        return float(cell.replace(",", ".") if separator != "," else cell)
    except ValueError:
        return None


def _row(
    cells: Sequence[str], columns: Sequence[Column], separator: str, name: str, line: int
) -> tuple[float, ...] | None:
    """Return the values of a line, None where one is missing."""
    row: list[float] = []
    for column in columns:
        if column.number >= len(cells):
            return None
        value = _number(cells[column.number], separator)
        if value is None:
            message = f"`{cells[column.number].strip()[:40]}` in column {column.number + 1} is no number"
            hint = "a comma within numbers needs semicolons or tabs between the columns"
            raise _error(message, hint, name, line)
        row.append(value)
    return tuple(row) if all(abs(one) <= _UNBELIEVABLE for one in row) else None


def _check_times(time: Array, lines: Sequence[int], name: str) -> None:
    steps = np.diff(time)
    back = np.flatnonzero(~(steps > 0.0))
    if back.size:
        first = int(back[0])
        message = (
            f"the time goes from {time[first]:g} s to {time[first + 1]:g} s, it must rise from line to line"
        )
        raise _error(message, "sort the lines, and log with one clock", name, lines[first + 1])
    rate = 1.0 / float(np.median(steps))
    if not _SLOWEST <= rate <= _QUICKEST:
        message = f"`{name}` has {rate:.4g} samples per second, allowed are {_SLOWEST:g} to {_QUICKEST:g}"
        raise _error(message, "is the unit of the time right? Such as `time [ms]`", name, 0)


def _check_coordinates(q: Array, lines: Sequence[int], name: str) -> None:
    beyond = np.flatnonzero((np.abs(q) > _MOST).any(axis=1))
    if beyond.size:
        first = int(beyond[0])
        worst = int(np.abs(q[first]).argmax())
        message = f"joint {worst + 1} is at {q[first, worst]:.4g} rad or m, which no joint is"
        raise _error(message, "is the unit in the header right?", name, lines[first])


def _gaps(missing: int, rows: int, name: str) -> Diagnostic:
    lines_missing = f"{missing} of {missing + rows} lines of `{name}`"
    message = f"{lines_missing} lack a value or have a wild one, and were left out"
    return GAPS.at(None, message, data={"lines": missing})


def _error(message: str, hint: str, name: str, line: int) -> CalibrationError:
    span = Span.whole_line(name, line) if line else None
    return CalibrationError(BAD_TRACE.at(span, message, hint=hint))
