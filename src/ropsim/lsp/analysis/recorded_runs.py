"""Times of tasks and lines in the recordings in the `out` folder of a project."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field
from pathlib import Path

from ropsim.core import RopsimError, frozen_dataclass
from ropsim.flow import TaskEvent
from ropsim.lsp.analysis.line_times import LineTimes, line_times

# Number of newest recordings that are read.
MOST = 8

# A file and its identity: time of its last change, size.
Stamp = tuple[Path, int, int]


@frozen_dataclass
class RecordedProgram:
    """One program of a recorded run.

    Attributes:
        icr_id: identity of the code that ran.
        durations: of each call of a task, in order of time [s], by the name of the task.
        code_lines: the source line of each instruction, as `icr.code_lines` has them; empty where unknown.
        lines: results of the lines that took time, by their numbers in the run.
        cell: content of the cell in which it ran; empty where unknown.
        source: name of its text.
        results: content on which the result of each line depends, see `icr.line_contents`; empty if unknown.
    """

    icr_id: str
    durations: Mapping[str, tuple[float, ...]]
    code_lines: tuple[int, ...] = ()
    lines: Mapping[int, LineTimes] = field(default_factory=dict)
    cell: str = ""
    source: str = ""
    results: Mapping[int, str] = field(default_factory=dict)


def recordings_in(folder: Path) -> tuple[Stamp, ...]:
    """Return the recordings of a project, the newest first."""
    found: list[tuple[int, Stamp]] = []
    try:
        for place in (folder / "out").glob("*.npz"):
            state = place.stat()
            found.append((state.st_mtime_ns, (place, state.st_mtime_ns, state.st_size)))
    except OSError:
        return ()
    return tuple(stamp for _, stamp in sorted(found, reverse=True)[:MOST])


class RecordedRuns:
    """Reads recordings once, and keeps the last requested ones of each project.

    Attributes:
        kept: the programs of recordings, by the folder that they are in.
    """

    def __init__(self) -> None:
        self.kept: dict[Path, dict[Stamp, tuple[RecordedProgram, ...]]] = {}

    def programs(self, stamps: Sequence[Stamp]) -> Iterator[RecordedProgram]:
        """Yield the programs of recordings of one project; one is read when it is come to."""
        if not stamps:
            return
        folder = stamps[0][0].parent
        known = self.kept.get(folder, {})
        kept = self.kept[folder] = {stamp: known[stamp] for stamp in stamps if stamp in known}
        for stamp in stamps:
            if stamp not in kept:
                kept[stamp] = programs_in(stamp[0])
            yield from kept[stamp]


def programs_in(place: Path) -> tuple[RecordedProgram, ...]:
    """Return the programs of a recording, none where it cannot be read."""
    try:
        from ropsim.records import read_recording

        recording = read_recording(place)
    except RopsimError:
        return ()
    made = []
    for station in recording.facts.stations:
        durations: dict[str, tuple[float, ...]] = {}
        for event in recording.events_of(TaskEvent):
            if event.station == station.name:
                durations[event.name] = (*durations.get(event.name, ()), event.duration)
        code_lines = recording.content.lines.get(station.name, ())
        lines = line_times(recording, station)
        content = recording.content
        results = content.results.get(station.name, {})
        made.append(
            RecordedProgram(
                station.icr_id, durations, code_lines, lines, content.cell, station.source, results
            )
        )
    return tuple(made)
