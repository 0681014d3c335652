"""The figures of one station of a run: of its program and its arm."""

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import field, replace
from typing import Protocol

from ropsim.core import frozen_dataclass
from ropsim.flow import (
    Event,
    GripEvent,
    MotionKind,
    MoveEvent,
    Recording,
    ReleaseEvent,
    Settling,
    SkipEvent,
    StationFacts,
    Waiting,
    settling_of,
    waiting_of,
)
from ropsim.views.accuracy import (
    ContourFigures,
    ContourRows,
    CornerFigures,
    StopFigures,
    contours,
    corner_figures,
    stop_figures,
)
from ropsim.views.channels import Peak, StationView, contact_forces, station_views
from ropsim.views.cycle import CycleTime, summarize_cycle
from ropsim.views.summary.device_summary import TaskSummary, summarize_tasks
from ropsim.views.summary.drive_use import DriveUse, summarize_drives
from ropsim.views.summary.energy_summary import EnergySummary, summarize_energy
from ropsim.views.summary.joint_summary import JointSummary, summarize_joints
from ropsim.views.summary.path_summary import PathSummary, summarize_path

DRAWN_CONTOURS = 8
"""Contours of a station that are drawn at most."""


@frozen_dataclass
class StationSummary:
    """The figures of one station.

    Attributes:
        facts: program, arm and limits.
        cycle_time: end of its last motion or instruction [s].
        moves: number of moves carried out, by kind (`PTP`, `LIN`).
        grips: number of times that a gripper closed on a part.
        empty_grips: number of times that it closed on nothing.
        releases: number of times the gripper was opened.
        skipped: moves that were refused and left out.
        share_in_motion: share of its cycle time in which its moves were on their way, outside of zones and
            within them; NaN for no time.
        settling: time of settling after moves.
        waiting: how long its program stood at waits.
        tasks: time per task.
        joints: extremes per joint.
        path: accuracy of the moves with a path of the tool.
        corners: how corners are passed that are rounded, in order of time.
        stops: how moves come to rest, in order of time; of a kinematic run there are none.
        contours: how true it was to tool paths that follow upon each other, in order of time; of a
            kinematic run there are none.
        cycle: composition of its cycle time.
        is_driven: whether drives moved its arm; without them it is where its reference is, exactly, and
            nothing is known of settling, torques and accuracy.
        energy: that its drives draw; None where their power is not known, as in a kinematic run.
        drives: how far it uses each of them; none in a kinematic run.
        contact: greatest force [N] of what its tool or held part was pressed on; None where nothing was.
    """

    facts: StationFacts
    cycle_time: float
    moves: Mapping[str, int]
    grips: int
    empty_grips: int
    releases: int
    skipped: tuple[SkipEvent, ...]
    share_in_motion: float
    settling: Settling
    waiting: Waiting
    tasks: tuple[TaskSummary, ...]
    joints: tuple[JointSummary, ...]
    path: PathSummary
    corners: tuple[CornerFigures, ...]
    stops: tuple[StopFigures, ...]
    contours: tuple[ContourFigures, ...] = ()
    cycle: CycleTime = field(default_factory=CycleTime)
    is_driven: bool = True
    energy: EnergySummary | None = None
    drives: tuple[DriveUse, ...] = ()
    contact: Peak | None = None


class Figures(Protocol):
    """Figures of a whole run and of each of its stations: time, moves, settling, waits."""

    @property
    def cycle_time(self) -> float:
        """Return the end of the last motion or instruction [s]."""
        ...

    @property
    def share_in_motion(self) -> float:
        """Return the share of the cycle time in which moves were on their way."""
        ...

    @property
    def is_driven(self) -> bool:
        """Return whether drives moved an arm."""
        ...

    @property
    def settling(self) -> Settling:
        """Return the time of settling after moves."""
        ...

    @property
    def waiting(self) -> Waiting:
        """Return how long programs stood at waits."""
        ...

    @property
    def moves(self) -> Mapping[str, int]:
        """Return the number of moves by kind."""
        ...

    @property
    def grips(self) -> int:
        """Return how often a gripper closed on a part."""
        ...

    @property
    def empty_grips(self) -> int:
        """Return how often a gripper closed on nothing."""
        ...

    @property
    def releases(self) -> int:
        """Return how often a gripper opened."""
        ...

    @property
    def joints(self) -> tuple[JointSummary, ...]:
        """Return the extremes per joint."""
        ...

    @property
    def path(self) -> PathSummary:
        """Return the accuracy of the moves with a path of the tool."""
        ...

    @property
    def corners(self) -> tuple[CornerFigures, ...]:
        """Return how rounded corners are passed."""
        ...

    @property
    def stops(self) -> tuple[StopFigures, ...]:
        """Return how moves come to rest."""
        ...

    @property
    def contours(self) -> tuple[ContourFigures, ...]:
        """Return how true the arm was to tool paths that follow upon each other."""
        ...


def summarize_stations(recording: Recording) -> tuple[StationSummary, ...]:
    """Return the figures of each station of a run, in the order of the cell."""
    return tuple(
        _station(_part(recording, facts), facts, summarize_cycle(recording, facts))
        for facts in recording.facts.stations
    )


def drawn_contours(recording: Recording, station: StationSummary) -> list[tuple[ContourFigures, ContourRows]]:
    """Return the contours of a station that are drawn, in order of time: those with the largest errors."""
    views = (one for one in station_views(recording) if one.facts.name == station.facts.name)
    found = [pair for view in views for pair in contours(view, station.stops)]
    worst = sorted((one.path_max for one, _ in found), reverse=True)[:DRAWN_CONTOURS]
    return [pair for pair in found if pair[0].path_max >= worst[-1]][:DRAWN_CONTOURS] if found else []


def end_of(events: Iterable[Event]) -> float:
    """Return when the last of some events was over [s]; 0 for none."""
    return max((event.end for event in events), default=0.0)


def moves_by_kind(events: Iterable[Event]) -> dict[str, int]:
    """Return how many moves of each kind were carried out: moves of the joints first, then tool paths."""
    counts = Counter(event.motion for event in events if isinstance(event, MoveEvent))
    known = [kind.value for kind in MotionKind if kind.value in counts]
    return {kind: counts[kind] for kind in (*known, *sorted(counts.keys() - known))}


def share_in_motion(cycles: Sequence[CycleTime]) -> float:
    """Return the share of the cycle times of stations together in which moves were on their way.

    It is that of the parts `motion` and `blending`, so it agrees with them. NaN for no time.
    """
    total = sum(one.whole.total for one in cycles)
    return sum(one.whole.moving for one in cycles) / total if total > 0.0 else math.nan


def _part(recording: Recording, facts: StationFacts) -> Recording:
    """Return the data of one station in a recording; all of it if there is only one."""
    if len(recording.facts.stations) == 1:
        return recording
    events = tuple(event for event in recording.events if event.station == facts.name)
    return replace(recording, events=events, facts=replace(recording.facts, stations=(facts,)))


def _station(recording: Recording, facts: StationFacts, cycle: CycleTime) -> StationSummary:
    events = recording.events
    cycle_time, views = end_of(events), station_views(recording)
    stops = tuple(one for station in views for one in stop_figures(station))
    return StationSummary(
        facts=facts,
        cycle_time=cycle_time,
        moves=moves_by_kind(events),
        grips=sum(isinstance(event, GripEvent) and event.part != "" for event in events),
        empty_grips=sum(isinstance(event, GripEvent) and event.part == "" for event in events),
        releases=sum(isinstance(event, ReleaseEvent) for event in events),
        skipped=tuple(event for event in events if isinstance(event, SkipEvent)),
        share_in_motion=share_in_motion([cycle]),
        settling=settling_of(events, cycle_time),
        waiting=waiting_of(events, cycle_time),
        tasks=summarize_tasks(recording),
        joints=summarize_joints(recording),
        path=summarize_path(recording),
        corners=tuple(one for station in views for one in corner_figures(station)),
        stops=stops,
        contours=tuple(one for station in views for one, _ in contours(station, stops)),
        cycle=cycle,
        is_driven=any(station.is_driven for station in views),
        energy=_energy(views, cycle),
        drives=tuple(one for station in views for one in summarize_drives(station)),
        contact=next((_contact(station) for station in views), None),
    )


def _contact(station: StationView) -> Peak | None:
    """Return the greatest contact force of a station; None where nothing was touched."""
    peak = station.peak(contact_forces(station))
    return peak if peak.value > 0.0 else None


def _energy(views: Sequence[StationView], cycle: CycleTime) -> EnergySummary | None:
    """Return the energy of the only one of some stations."""
    passes = {line.line: line.passes for line in cycle.lines}
    return next((summarize_energy(station, passes) for station in views), None)
