"""Comparison of a program with and without changes."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import PurePath

from ropsim.collision import NO_MESHES, MeshPoints
from ropsim.core import Diagnostic
from ropsim.flow import GripEvent, MoveEvent, Recording
from ropsim.icr import Program
from ropsim.model import Cell
from ropsim.simulation import RunOptions, needs_check, run, run_collisions, with_collisions
from ropsim.views import Alternative, Comparison, summarize
from ropsim.workbench.what_if.applying import adaptation, changed_cell
from ropsim.workbench.what_if.change import NOTHING_COMPARED, Change, Subject

_FIGURES = re.compile(r"\d+(?:\.\d+)?")


def compare(
    recording: Recording,
    cell: Cell,
    codes: dict[str, Program],
    changes: Sequence[Change | Subject],
    options: RunOptions,
    meshes: MeshPoints = NO_MESHES,
) -> Comparison:
    """Return the run of a program next to runs with one change each.

    Args:
        recording: of the unchanged program, in the cell and with the options.
        cell: unchanged cell.
        codes: verified programs by station.
        changes: as `read_change` returns them; `Subject.ZONES` stands for one of each line with a zone.
        options: of all runs.
        meshes: points of the meshes of the cell; collisions are checked where they are in the recording.

    Returns:
        the comparison; without alternatives if the unchanged program does not end.

    Raises:
        WhatIfError: X896, the cell lacks the entity to be changed.
    """
    summary = summarize(recording)
    if not summary.cycle_time_valid:
        return Comparison(summary.cycle_time, (), (_unfinished(),))
    wanted = list(_single(changes, recording))
    notes = tuple(_in_vain(changes, recording))
    cells = [changed_cell(cell, change) for change in wanted]
    several = len({change.source for change in wanted if change.source}) > 1
    known = {content_of(found) for found in recording.findings}
    alternatives = []
    for change, changed in zip(wanted, cells, strict=True):
        other = run(changed, codes, replace(options, adapt=adaptation(change)))
        if needs_check(other) and not needs_check(recording):
            other = with_collisions(other, run_collisions(other, changed, meshes))
        judged = summarize(other)
        new = tuple(_told(found for found in other.findings if content_of(found) not in known))
        name = (
            f"{change.text} of {PurePath(change.source).name}" if several and change.source else change.text
        )
        figures = judged.cycle_time, judged.cycle_time_valid
        alternatives.append(Alternative(name, *figures, new, judged.drawn))
    return Comparison(summary.cycle_time, tuple(alternatives), notes, summary.drawn)


def _single(changes: Sequence[Change | Subject], recording: Recording) -> Iterable[Change]:
    """Yield the changes one by one; changes of zones if some are achieved, `each` as one for each line.

    The mass of parts is changed if some are gripped.
    """
    blended, grips = _blended_moves(recording), _grips(recording)
    for change in changes:
        if isinstance(change, Subject):
            yield from (Change(change, line=line, source=source) for source, line in blended)
        elif grips if _is_of_parts(change) else blended or not _is_of_zones(change):
            yield change


def _in_vain(changes: Iterable[Change | Subject], recording: Recording) -> Iterable[Diagnostic]:
    """Yield why changes are not tried."""
    if any(map(_is_of_zones, changes)) and not _blended_moves(recording):
        yield _without_zones(recording)
    if any(map(_is_of_parts, changes)) and not _grips(recording):
        yield NOTHING_COMPARED.at(
            None,
            "no part is gripped in this run: what parts weigh changes nothing",
            hint="`tool=…kg` changes the mass of the tools",
        )


def _is_of_parts(change: Change | Subject) -> bool:
    return isinstance(change, Change) and change.subject is Subject.PAYLOAD


def _grips(recording: Recording) -> bool:
    return any(one.part for one in recording.events_of(GripEvent))


def _is_of_zones(change: Change | Subject) -> bool:
    return (change if isinstance(change, Subject) else change.subject) is Subject.ZONES


def _blended_moves(recording: Recording) -> list[tuple[str, int]]:
    """Return source and line of the moves whose zones were flown, each once."""
    moves = (move for move in recording.events_of(MoveEvent) if move.flown > 0.0)
    return sorted({(move.span.source, move.span.line) if move.span else ("", 0) for move in moves})


def _unfinished() -> Diagnostic:
    return NOTHING_COMPARED.at(
        None,
        "no change was tried: the program as it is does not come to its end, so it has no cycle time",
        hint="mend what is found in the run first",
    )


def _without_zones(recording: Recording) -> Diagnostic:
    asked = any(move.zone > 0.0 for move in recording.events_of(MoveEvent))
    found = (
        "no zone of this program is flown, the arm stops at all of them"
        if asked
        else "no zone in this program"
    )
    return NOTHING_COMPARED.at(None, f"{found}: there is none to take away", hint="write `blend` at a move")


def _told(findings: Iterable[Diagnostic]) -> Iterable[Diagnostic]:
    """Yield findings, each cause once."""
    return {content_of(found): found for found in reversed(tuple(findings))}.values()


def content_of(found: Diagnostic) -> tuple[str, str, int, str]:
    """Return the key of a finding across runs: code, place, and message without its figures.

    Names in backticks stay, such as names of joints and parts, which may be numbers.
    """
    span, parts = found.span, found.message.split("`")
    parts[::2] = [_FIGURES.sub("", part) for part in parts[::2]]
    return found.code, span.source if span else "", span.line if span else 0, "`".join(parts)
