"""Columns of a trace: quantity and unit."""

import math
import re
from collections.abc import Sequence

from ropsim.calibration.diagnostics import BAD_TRACE, CalibrationError
from ropsim.core import Span, did_you_mean, frozen_dataclass
from ropsim.model import Joint, JointType

_TITLE = re.compile(r"([^\[(]*)(?:[\[(]([^\])]*)[\])])?")
_TIMES = {"s": 1.0, "sec": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6}
_TURNS = {"deg": math.radians(1.0), "°": math.radians(1.0), "rad": 1.0, "mrad": 1e-3}
_LENGTHS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0}
_TIME_NAMES = frozenset({"time", "t", "timestamp", "zeit", "seconds"})
_BEFORE = ("", "j", "q", "a", "joint", "axis", "achse", "jointposition", "position")
_AXIS = re.compile(r"(?:j|q|a|joint|axis|achse)[0-9]{1,2}(?:position|pos)?")
_BEHIND = ("", "position", "pos", "commandedposition")


@frozen_dataclass
class Column:
    """A column.

    Attributes:
        number: from 0.
        factor: SI units per unit of the column.
    """

    number: int
    factor: float


def columns_of(titles: Sequence[str], joints: Sequence[Joint], name: str, line: int) -> tuple[Column, ...]:
    """Return the columns of the time and of each axis, in this order, by the titles of a header.

    Args:
        titles: cells of the header.
        joints: of the axes, n of them.
        name: of the file.
        line: in which the header stands.

    Raises:
        CalibrationError: X888, a column is missing or has an unknown unit.
    """
    words, units = zip(*(_title(one) for one in titles), strict=True)
    time = next((k for k, word in enumerate(words) if word in _TIME_NAMES), None)
    if time is None:
        message = f"`{name}` has no column `time`, its columns are {_listed(titles)}"
        raise _error(message, "call the column of the time `time [s]`", name, line)
    named = [_number(words, joint.name) for joint in joints]
    found = [number for number in named if number is not None]
    if len(found) < len(joints):
        found = [number for number in range(len(titles)) if number != time]
    else:  # columns of more axes belong to another robot, others do no harm
        found += [k for k, word in enumerate(words) if _AXIS.fullmatch(word) and k not in found]
    if len(found) != len(joints) or len(set(found)) != len(found):
        raise wrong_count(len(found), joints, name, line)
    made = [Column(time, _factor(units[time], _TIMES, "s", titles[time], name, line))]
    for joint, number in zip(joints, found, strict=True):
        turns = joint.measure is JointType.REVOLUTE
        known, usual = (_TURNS, "deg") if turns else (_LENGTHS, "mm")
        made.append(Column(number, _factor(units[number], known, usual, titles[number], name, line)))
    return tuple(made)


def plain_columns(count: int, joints: Sequence[Joint], name: str, line: int) -> tuple[Column, ...]:
    """Return the columns of a table without header: time in seconds, then the axes in degrees or millimetres.

    Raises:
        CalibrationError: X888, it has another number of columns.
    """
    if count != len(joints) + 1:
        raise wrong_count(count - 1, joints, name, line)
    factors = [_TURNS["deg"] if one.measure is JointType.REVOLUTE else _LENGTHS["mm"] for one in joints]
    return Column(0, 1.0), *(Column(k, factor) for k, factor in enumerate(factors, start=1))


def wrong_count(found: int, joints: Sequence[Joint], name: str, line: int) -> CalibrationError:
    """Return the error that a trace has another number of axes than the robot."""
    names = ", ".join(f"j{one.name}" if one.name.isdigit() else one.name for one in joints)
    axes = "1 axis" if len(joints) == 1 else f"{len(joints)} axes"
    message = (
        f"`{name}` has {found} column{'' if found == 1 else 's'} of joints, the robot has {axes}: {names}"
    )
    return _error(message, "is the trace of this robot? Name the columns as the axes are called", name, line)


def _title(text: str) -> tuple[str, str]:
    """Return the name in a title, small letters and digits only, and its unit."""
    parts = _TITLE.match(text.strip())
    word, unit = (parts[1], parts[2] or "") if parts else (text, "")
    return re.sub(r"[^a-z0-9]", "", word.lower()), unit.strip()


def _number(words: Sequence[str], joint: str) -> int | None:
    name = re.sub(r"[^a-z0-9]", "", joint.lower())
    for behind in _BEHIND:
        for before in _BEFORE:
            if before + name + behind in words:
                return words.index(before + name + behind)
    return None


def _factor(unit: str, known: dict[str, float], usual: str, title: str, name: str, line: int) -> float:
    wanted = unit.lower() or usual
    wanted = {"degree": "deg", "degrees": "deg", "seconds": "s"}.get(wanted, wanted)
    if wanted in known:
        return known[wanted]
    message = f"`{name}` has the unit `{unit[:20]}` in column `{title[:40]}`, known are {', '.join(known)}"
    raise _error(message, did_you_mean(unit, known), name, line)


def _listed(titles: Sequence[str]) -> str:
    return ", ".join(f"`{one.strip()[:24]}`" for one in titles[:8]) + (" …" if len(titles) > 8 else "")


def _error(message: str, hint: str, name: str, line: int) -> CalibrationError:
    return CalibrationError(BAD_TRACE.at(Span.whole_line(name, line), message, hint=hint))
