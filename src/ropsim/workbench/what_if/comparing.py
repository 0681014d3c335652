"""A program as it is beside what it would be with changes."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import PurePath

from ropsim.core import Diagnostic
from ropsim.flow import MoveEvent, Recording
from ropsim.icr import Program
from ropsim.model import Cell
from ropsim.simulation import RunOptions, run
from ropsim.views import Alternative, Comparison, summarize
from ropsim.workbench.what_if.applying import adaptation, changed_cell
from ropsim.workbench.what_if.change import Change, Subject


def compare(
    recording: Recording,
    cell: Cell,
    codes: dict[str, Program],
    changes: Sequence[Change | Subject],
    options: RunOptions,
) -> Comparison:
    """Return the run of a program beside runs with one change each.

    Args:
        recording: of the program as it is, in the cell and with the options.
        cell: as it is.
        codes: verified programs by station.
        changes: as `read_change` returns them; `Subject.ZONES` stands for one of each line with a zone.
        options: of all runs.

    Raises:
        WhatIfError: X896, the cell has nothing of what is to be changed.
    """
    wanted = list(_single(changes, recording))
    cells = [changed_cell(cell, change) for change in wanted]
    summary = summarize(recording)
    several = len({change.source for change in wanted if change.source}) > 1
    known = {_place(found) for found in recording.findings}
    alternatives = []
    for change, changed in zip(wanted, cells, strict=True):
        other = run(changed, codes, replace(options, adapt=adaptation(change)))
        judged = summarize(other)
        new = tuple(_told(found for found in other.findings if _place(found) not in known))
        name = (
            f"{change.text} of {PurePath(change.source).name}" if several and change.source else change.text
        )
        alternatives.append(Alternative(name, judged.cycle_time, judged.cycle_time_valid, new))
    return Comparison(summary.cycle_time, tuple(alternatives))


def _single(changes: Sequence[Change | Subject], recording: Recording) -> Iterable[Change]:
    """Yield the changes one by one; one for each line whose zone was flown in place of a subject."""
    for change in changes:
        if isinstance(change, Change):
            yield change
        else:
            moves = (move for move in recording.events_of(MoveEvent) if move.flown > 0.0)
            flown = {(move.span.source, move.span.line) for move in moves if move.span}
            yield from (Change(change, line=line, source=source) for source, line in sorted(flown))


def _told(findings: Iterable[Diagnostic]) -> Iterable[Diagnostic]:
    """Yield findings, each cause once."""
    seen = set()
    for found in findings:
        if _place(found) not in seen:
            seen.add(_place(found))
            yield found


def _place(found: Diagnostic) -> tuple[str, str, int]:
    return found.code, found.span.source if found.span else "", found.span.line if found.span else 0
