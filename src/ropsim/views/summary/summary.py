"""The figures of a run on one page: printed by `ropsim run` and shown first in the report."""

import math
from collections.abc import Iterable, Mapping

from ropsim.core import Category, Diagnostic, Severity, frozen_dataclass
from ropsim.flow import (
    CalledTask,
    Destinations,
    GripEvent,
    ParameterOrigin,
    Recording,
    ReleaseEvent,
    RunFacts,
    Settling,
    SkipEvent,
    Waiting,
    settling_of,
    waiting_of,
)
from ropsim.views.accuracy import ContourFigures, CornerFigures, StopFigures
from ropsim.views.channels import invalid_samples
from ropsim.views.summary.device_summary import DeviceSummary, TaskSummary, summarize_devices, summarize_tasks
from ropsim.views.summary.findings import FindingGroup, below_causes, group_findings
from ropsim.views.summary.joint_summary import JointSummary, summarize_joints
from ropsim.views.summary.path_summary import PathSummary, summarize_path
from ropsim.views.summary.station_summary import (
    StationSummary,
    end_of,
    moves_by_kind,
    share_in_motion,
    summarize_stations,
)
from ropsim.views.summary.unchecked import ByHand, Unchecked, by_hand, unchecked


@frozen_dataclass
class Summary:
    """The figures of one run.

    Attributes:
        facts: stations and programs, arms, limits.
        duration: simulated time [s].
        cycle_time: end of the last motion or instruction of all stations [s].
        moves: number of moves carried out, by kind (`PTP`, `LIN`).
        grips: number of times that a gripper closed on a part.
        empty_grips: number of times that it closed on nothing.
        releases: number of times the gripper was opened.
        skipped: moves that were refused and left out; with any, the cycle time is not valid.
        share_in_motion: share of the cycle times of all stations together in which their moves were on
            their way, outside of zones and within them; NaN for no time.
        settling: settling after moves, as a share of the cycle times of all stations together.
        waiting: how long programs stood at waits, as a share of the same.
        tasks: time per task.
        joints: extremes per joint.
        path: accuracy of the moves with a path of the tool.
        corners: how corners are passed that are rounded, in order of time.
        stops: how moves come to rest, in order of time; of a kinematic run there are none.
        contours: how true arms were to tool paths that follow upon each other; as `stops`.
        findings: grouped findings of compiling and of the run, worst severity first; consequences of a line
            follow the findings there.
        error_count: number of findings of severity error, repeats included.
        warning_count: number of warnings, repeats included.
        hint_count: number of hints, repeats included.
        invalid_samples: number of samples of q, qd and tau that are not finite.
        by_hand: how long it was held and slowed; the cycle time has it within.
        unchecked: omitted checks.
        destinations: how many parts are at their destinations; None without any.
        stations: the figures of each one; those above are of all together.
        devices: summaries of devices.
    """

    facts: RunFacts
    duration: float
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
    contours: tuple[ContourFigures, ...]
    findings: tuple[FindingGroup, ...]
    error_count: int
    warning_count: int
    hint_count: int
    invalid_samples: int
    by_hand: ByHand
    unchecked: Unchecked
    destinations: Destinations | None = None
    stations: tuple[StationSummary, ...] = ()
    devices: tuple[DeviceSummary, ...] = ()

    @property
    def is_driven(self) -> bool:
        """Return whether drives moved an arm of the run."""
        if not self.stations:
            return not self.facts.is_kinematic
        return any(one.is_driven for one in self.stations)

    @property
    def drawn(self) -> float:
        """Return the energy that the drives of all stations draw [J]; NaN where no power is known."""
        known = [one.energy.drawn for one in self.stations if one.energy]
        return sum(known) if known else math.nan

    @property
    def title(self) -> str:
        """Return project and programs, each once, or `run` where none of them has a name."""
        names = (self.facts.project, *(station.program for station in self.facts.stations))
        return " / ".join(dict.fromkeys(name for name in names if name)) or "run"

    @property
    def robot(self) -> str:
        """Return maker and model of the arm, of each one where there are several stations."""
        return ", ".join(dict.fromkeys(one.title or one.robot for one in self.facts.stations))

    @property
    def called(self) -> tuple[CalledTask, ...]:
        """Return the tasks of knowledge bases that programs of the run are made of, each once."""
        return tuple(dict.fromkeys(one for station in self.facts.stations for one in station.called))

    @property
    def origins(self) -> tuple[ParameterOrigin, ...]:
        """Return where the parameters of arms and controllers come from, each once."""
        return tuple(dict.fromkeys(origin for station in self.facts.stations for origin in station.origins))

    @property
    def cycle_time_valid(self) -> bool:
        """Return whether the whole program was carried out, so that the cycle time is that of the program."""
        return not self.skipped and self.invalid_samples == 0 and not self.unfinished

    @property
    def unfinished(self) -> bool:
        """Return whether a program was ended before its own end."""
        return any(one.first.category in {Category.UNFINISHED, Category.STOPPED} for one in self.findings)

    @property
    def stopped_by_hand(self) -> bool:
        """Return whether it is a live run that did not come to the program's end."""
        return any(one.first.category is Category.STOPPED for one in self.findings)


def summarize(recording: Recording, before: Iterable[Diagnostic] = ()) -> Summary:
    """Return the figures of a recording; absent channels and infinite samples yield NaN.

    Args:
        recording: of the run.
        before: findings of reading and compiling; they count as findings of the run.
    """
    events, stations = recording.events, summarize_stations(recording)
    cycle_time = end_of(events)
    hand = by_hand(recording.facts.overrides, cycle_time, recording.duration)
    together = sum(one.cycle_time for one in stations) or cycle_time
    whole = stations[0] if len(stations) == 1 else None
    findings = (*before, *recording.findings)
    groups = group_findings(findings)
    severities = [finding.severity for finding in findings]
    return Summary(
        facts=recording.facts,
        duration=recording.duration,
        cycle_time=cycle_time,
        moves=moves_by_kind(events),
        grips=sum(isinstance(event, GripEvent) and event.part != "" for event in events),
        empty_grips=sum(isinstance(event, GripEvent) and event.part == "" for event in events),
        releases=sum(isinstance(event, ReleaseEvent) for event in events),
        skipped=tuple(event for event in events if isinstance(event, SkipEvent)),
        share_in_motion=share_in_motion([one.cycle for one in stations]),
        settling=settling_of(events, together),
        waiting=waiting_of(events, together),
        tasks=whole.tasks if whole else summarize_tasks(recording),
        joints=whole.joints if whole else summarize_joints(recording),
        path=whole.path if whole else summarize_path(recording),
        corners=tuple(one for station in stations for one in station.corners),
        stops=tuple(one for station in stations for one in station.stops),
        contours=tuple(one for station in stations for one in station.contours),
        findings=below_causes(sorted(groups, key=lambda group: group.first.severity.rank)),
        error_count=severities.count(Severity.ERROR),
        warning_count=severities.count(Severity.WARNING),
        hint_count=severities.count(Severity.HINT),
        invalid_samples=invalid_samples(recording),
        by_hand=hand,
        unchecked=unchecked(recording.facts, recording.findings, hand),
        destinations=recording.facts.destinations if recording.facts.destinations.wanted else None,
        stations=stations,
        devices=summarize_devices(recording),
    )
