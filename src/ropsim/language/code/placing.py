"""Code where it stands and lies: jumps with the addresses of their targets, and lines of the text.

Neither is a query. An additional instruction moves all code below it, an additional line moves the lines of
all units below: a group is placed again if its code, address or lines differ from the last time, else the
last result is used.
"""

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, field
from itertools import chain
from typing import Generic, TypeVar

from ropsim import icr
from ropsim.language.code.main_code import LoweredParts
from ropsim.language.code.task_codes import Made
from ropsim.language.questions import Group
from ropsim.program import Lowered, Places, SourceMap, joined, shifted

P = TypeVar("P")
T = TypeVar("T")


Lying = tuple[Places | None, ...]
"""Where units lie, None for units without lines."""


@dataclass(slots=True)
class _Memory(Generic[P, T]):
    """Results by group, with the object from which each was made, and its place."""

    known: dict[Group, tuple[object, P, T]] = field(default_factory=dict)

    def find(self, group: Group, code: object, place: P) -> T | None:
        """Return the result for the same object and place, None if there is none."""
        found = self.known.get(group)
        return found[2] if found is not None and found[0] is code and found[1] == place else None

    def place(self, group: Group) -> P | None:
        """Return the place for which something was made last, None for none."""
        found = self.known.get(group)
        return found[1] if found is not None else None

    def keep(self, group: Group, code: object, place: P, made: T) -> None:
        """Remember a result."""
        self.known[group] = code, place, made

    def forget_others(self, groups: Collection[Group]) -> None:
        """Let go of all groups but these, which are known."""
        if len(self.known) > len(groups):
            self.known = {group: self.known[group] for group in groups}


@dataclass(slots=True)
class PlacedCode:
    """Result of the last placing: code and lines of each part and in total, procedures, lines of units."""

    codes: _Memory[int, tuple[icr.Step, ...]] = field(default_factory=_Memory)
    lines: _Memory[Lying, tuple[int, ...]] = field(default_factory=_Memory)
    all_lines: tuple[list[tuple[int, ...]], tuple[int, ...]] = ([], ())
    procedures: _Memory[Lying, tuple[icr.Procedure, ...]] = field(default_factory=_Memory)
    units: Mapping[str, Places] = field(default_factory=dict)


def placed_main(
    last: PlacedCode, groups: Mapping[Group, LoweredParts], start: int, places: SourceMap
) -> Lowered:
    """Return the control statements as one procedure that begins with its instruction `start`."""
    units = SourceMap("", places.units)
    code: list[tuple[icr.Step, ...]] = []
    lines: list[tuple[int, ...]] = []
    address = start
    for group, one in groups.items():
        moved, lying = last.codes.find(group, one, address), tuple(map(units.units.get, group))
        if moved is None:
            moved = shifted(one.whole.code, address, one.jumps)
            last.codes.keep(group, one, address, moved)
        placed = last.lines.find(group, one, lying)
        if placed is None:
            known = last.lines.known.get(group)
            again = _moved(known[1], known[2], lying) if known is not None and known[0] is one else None
            placed = again or _lines(one.parts, units)
            last.lines.keep(group, one, lying, placed)
        code.append(moved)
        lines.append(placed)
        address += len(moved)
    last.codes.forget_others(groups)
    last.lines.forget_others(groups)
    if lines != last.all_lines[0]:  # mostly nothing has been moved
        last.all_lines = lines, tuple(chain.from_iterable(lines))
    every = tuple(chain.from_iterable(code))
    return joined([one.whole for one in groups.values()], every, last.all_lines[1], places.source)


def placed_tasks(
    last: PlacedCode, groups: Mapping[Group, tuple[Made, ...]], places: SourceMap
) -> tuple[icr.Procedure, ...]:
    """Return the procedures of tasks with their source lines."""
    units = SourceMap("", places.units)
    is_still = last.units == places.units
    found: list[tuple[icr.Procedure, ...]] = []
    for group, made in groups.items():
        lying = last.procedures.place(group) if is_still else None
        if lying is None or len(lying) != len(made):
            lying = tuple(units.units.get(one.unit) for one in made)
        placed = last.procedures.find(group, made, lying)
        if placed is None:
            placed = tuple(_procedure(one, units) for one in made)
            last.procedures.keep(group, made, lying, placed)
        found.append(placed)
    last.procedures.forget_others(groups)
    last.units = places.units
    return tuple(chain.from_iterable(found))


def _moved(before: Lying, lines: tuple[int, ...], now: Lying) -> tuple[int, ...] | None:
    """Return the lines of units that have moved together; None where they have not."""
    if before[0] is None or now[0] is None or 0 in lines:
        return None
    shift = now[0].first - before[0].first
    for one, other in zip(before, now, strict=True):
        if one is None or other is None or other.offsets != one.offsets or other.first - one.first != shift:
            return None
    return tuple(map(shift.__add__, lines))


def _lines(parts: Iterable[Lowered], units: SourceMap) -> tuple[int, ...]:
    return tuple(chain.from_iterable(units.lines(one.unit, one.lines) for one in parts))


def _procedure(made: Made, units: SourceMap) -> icr.Procedure:
    one = made.procedure
    start = (0,) * (len(one.code) - len(made.lines))
    lines = start + units.lines(made.unit, made.lines)
    return icr.Procedure(one.name, one.parameters, one.locals, one.results, one.code, lines)
