"""Change of a what-if run, and its text form: `payload=3kg`."""

import math
import re
from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType

from ropsim.core import Category, RopsimError, Severity, define, did_you_mean, frozen_dataclass

BAD_CHANGE = define(
    "X896",
    "bad-change",
    Severity.ERROR,
    "a change for a what-if run that cannot be",
    """
`--what-if NAME=VALUE` runs the program with one thing changed. Names and values are `speed=120%`,
`acceleration=80%` (of what program and cell give), `payload=3kg` (each part), `tool=2kg` (each tool that has
a mass), `zones=stop` (every move stops) and `zones=each` (one run for each line, in which its moves stop).
""",
    Category.USAGE,
)

NOTHING_COMPARED = define(
    "X897",
    "nothing-compared",
    Severity.WARNING,
    "a what-if run that would say nothing, and was not made",
    """
A what-if run compares cycle times. Where the program as it is does not come to its end, because a move is
skipped, a program is ended or waits in vain, it has no cycle time that another one could be compared with:
mend what is found first. `zones=stop` and `zones=each` compare with what is there: they need a zone that is
flown in the run. `payload=3kg` needs a part that is gripped in it.
""",
)


class WhatIfError(RopsimError):
    """A change that cannot be, or has nothing to change; carries the finding."""


class Subject(Enum):
    """Subject of a change."""

    SPEED = "speed"
    ACCELERATION = "acceleration"
    PAYLOAD = "payload"
    TOOL = "tool"
    ZONES = "zones"


@frozen_dataclass
class Change:
    """One thing that is changed.

    Attributes:
        subject: its subject.
        value: factor of speeds and accelerations, mass [kg]; 0 for zones, which are none then.
        line: source line whose zones are meant; 0 for all.
        source: name of the text in which that line stands.
    """

    subject: Subject
    value: float = 0.0
    line: int = 0
    source: str = ""

    @property
    def text(self) -> str:
        """Return the change as people write it."""
        match self.subject:
            case Subject.SPEED | Subject.ACCELERATION:
                return f"{self.subject.value}={self.value * 100.0:g}%"
            case Subject.PAYLOAD | Subject.TOOL:
                return f"{self.subject.value}={self.value:g}kg"
            case Subject.ZONES:
                return f"zones=stop in line {self.line}" if self.line else "zones=stop"


@frozen_dataclass
class _Sort:
    """A sort of value: units with their factors, and the range that is allowed, in units of the first one."""

    units: Mapping[str, float]
    low: float
    high: float

    @property
    def example(self) -> str:
        unit = next(iter(self.units))
        return f"{self.low:g}{unit} to {self.high:g}{unit}"


_SHARE = _Sort(MappingProxyType({"%": 0.01}), 1.0, 500.0)
_MASS = _Sort(MappingProxyType({"kg": 1.0}), 0.0, 10_000.0)
_SORTS: Mapping[Subject, _Sort] = MappingProxyType(
    {
        Subject.SPEED: _SHARE,
        Subject.ACCELERATION: _SHARE,
        Subject.PAYLOAD: _MASS,
        Subject.TOOL: _MASS,
    }
)
_STOP, EACH = "stop", "each"
_NUMBER = re.compile(r"(-?[0-9]{1,9}(?:\.[0-9]{1,9})?) ?([^0-9.\s]{0,20})")


def read_change(text: str) -> Change | Subject:
    """Return the change in a text; the subject alone for `zones=each`.

    Args:
        text: such as `speed=120%`, from anywhere.

    Raises:
        WhatIfError: X896, it contains none.
    """
    name, sign, value = (part.strip() for part in text.partition("="))
    known = [subject.value for subject in Subject]
    if name not in known or not sign:
        found = f"`{name[:40]}` cannot be changed, known are {', '.join(known)}"
        if name in known:
            found = f"`{name}` has no value"
        raise _error(found, did_you_mean(name, known) if name not in known else "write `NAME=VALUE`")
    subject = Subject(name)
    if subject is Subject.ZONES:
        if value not in (_STOP, EACH):
            raise _error(f"`{value[:40]}` is no value of `zones`, known are {_STOP}, {EACH}", "")
        return subject if value == EACH else Change(subject)
    return Change(subject, _number(name, value, _SORTS[subject]))


def _number(name: str, text: str, sort: _Sort) -> float:
    found = _NUMBER.fullmatch(text)
    if not found or found[2] not in sort.units:
        units = " or ".join(f"`{unit}`" for unit in sort.units)
        raise _error(f"`{text[:40]}` is no value of `{name}`, it is a number with the unit {units}", "")
    factor = sort.units[found[2]]
    value = float(found[1]) * factor
    first = next(iter(sort.units.values()))
    if not sort.low * first <= value <= sort.high * first or not math.isfinite(value):
        raise _error(f"`{text}` is no value of `{name}`, allowed are {sort.example}", "")
    return value


def _error(found: str, hint: str) -> WhatIfError:
    return WhatIfError(
        BAD_CHANGE.at(None, found, hint=hint or "such as `speed=120%`, `payload=3kg`, `zones=stop`")
    )
