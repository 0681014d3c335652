"""The course of a stretch: runs of its parts, one behind or over the other."""

from collections.abc import Sequence

from ropsim.controller.corners import Overlap
from ropsim.controller.parts import Part
from ropsim.controller.pieces import Piece
from ropsim.motion import TimeLaw
from ropsim.spatial import record


@record
class Run:
    """A part of a stretch at its time.

    Attributes:
        part: pieces that are walked together.
        start: motion time at which it begins [s].
        overlap: for how long the run before still lasts then [s].
    """

    part: Part
    start: float
    overlap: float

    @property
    def pieces(self) -> tuple[Piece, ...]:
        """Return its pieces in order."""
        return self.part.pieces

    @property
    def law(self) -> TimeLaw:
        """Return when it is where on its pieces."""
        return self.part.law

    @property
    def end(self) -> float:
        """Return the motion time at which it ends [s]."""
        return self.start + self.law.duration


@record
class Course:
    """All runs of a stretch.

    Attributes:
        runs: in order; none where nothing moves.
        ends: motion times at which the moves end [s]: in the middle of their corners, or where they stop.
    """

    runs: tuple[Run, ...]
    ends: tuple[float, ...]

    @property
    def duration(self) -> float:
        """Return the motion time from start to end [s]."""
        return self.runs[-1].end if self.runs else 0.0

    def alone(self, number: int) -> tuple[float, float]:
        """Return the motion times between which no other run goes on beside one [s].

        Args:
            number: of the run.
        """
        run, behind = self.runs[number], self.runs[number + 1 : number + 2]
        return run.start + run.overlap, run.end - (behind[0].overlap if behind else 0.0)


def course_of(parts: Sequence[Part], legs: int) -> Course:
    """Return the course through the parts of a stretch.

    Args:
        parts: of it.
        legs: number of its moves.
    """
    runs: list[Run] = []
    over: Overlap | None = None
    for part in parts:
        before = runs[-1] if runs else None
        both = 0.0
        if before and over:
            last = len(before.pieces) - 1
            leave = over.leave - before.pieces[last].begin
            ends = before.law.duration - before.law.time_of(last, leave)
            both = min(ends, part.law.time_of(0, over.enter))
        runs.append(Run(part, before.end - both if before else 0.0, both))
        over = part.over
    return Course(tuple(runs), tuple(_ends(runs, legs)))


def _ends(runs: Sequence[Run], legs: int) -> list[float]:
    ends = [0.0] * legs
    for place, run in enumerate(runs):
        behind = runs[place + 1] if place + 1 < len(runs) else None
        round_corners = [number for number, piece in enumerate(run.pieces) if piece.corner]
        if round_corners:
            halves = [run.pieces[number].joints.length / 2.0 for number in round_corners]
            for number, middle in zip(
                round_corners, run.law.times_of(round_corners, halves).tolist(), strict=True
            ):
                ends[run.pieces[number].leg] = run.start + middle
        ends[run.pieces[-1].leg] = run.end - (0.5 * behind.overlap if behind else 0.0)
    for leg in range(1, legs):
        ends[leg] = max(ends[leg], ends[leg - 1])
    return ends
