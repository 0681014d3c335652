"""Parts of a stretch, each walked from rest to rest, with their time laws."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from ropsim.core import maker
from ropsim.motion import Stages, SynchronisedJoints, TimeLaw, plan_stages, rest_to_rest
from ropsim.planning.blends.blend import Overlap
from ropsim.planning.trajectory.segments import Piece, Walk
from ropsim.planning.trajectory.timing_kernel import lay_horizons
from ropsim.spatial import Array, record

Counts = npt.NDArray[np.intp]
_NOTHING, _ONE = np.zeros(1, dtype=np.intp), np.ones(1, dtype=np.intp)


@record
class Part:
    """Pieces that are walked together from rest to rest, and how.

    Attributes:
        pieces: in order.
        stages: with which they are planned, of all pieces in a row; none where the path is one of time.
        counts: how many stages each piece has, shape (p,).
        law: when the motion is where on them; it counts pieces, whatever the stages of each.
        over: how it goes over into the next one; None where it stops.
    """

    pieces: tuple[Piece, ...]
    stages: Stages
    counts: Counts
    law: TimeLaw
    over: Overlap | None

    @property
    def has_stages(self) -> bool:
        """Return whether its time law is planned with stages; else its path is one of time."""
        return len(self.stages) > 0

    @property
    def leads_tool(self) -> bool:
        """Return whether it is on a path of the tool, so that limits of the tool hold."""
        return self.pieces[0].tool is not None

    @property
    def borders(self) -> Array:
        """Return the places at which pieces begin, from the start on, and the end of the last, (p + 1,)."""
        ends = np.append(0.0, self.stages.ends)
        return np.asarray(ends[np.append(0, np.cumsum(self.counts))])


_part = maker(Part)


def parts_of(walks: Sequence[Walk], look_ahead: int) -> tuple[Part, ...]:
    """Return the parts of a stretch between which the arm stops or motions overlap.

    Args:
        walks: the pieces, as from `pieces_of`.
        look_ahead: how many moves beyond the present one are known.
    """
    even = [number for number, (pieces, _) in enumerate(walks) if len(pieces) == 1 and pieces[0].is_even]
    laws = {}
    if even:
        rows = np.concatenate([walks[number][0][0].stages.rows for number in even])
        laws = dict(zip(even, rest_to_rest(rows), strict=True))
    return tuple(
        _part(tuple(pieces), pieces[0].stages, _ONE, laws[number], over)
        if number in laws
        else _quickest(pieces, over, look_ahead)
        for number, (pieces, over) in enumerate(walks)
    )


def part_of(pieces: Sequence[Piece], over: Overlap | None, look_ahead: int) -> Part:
    """Return pieces with their time law: planned stage by stage, told piece by piece.

    Args:
        pieces: that are walked together from rest to rest.
        over: how they go over into the next ones; None where they stop.
        look_ahead: how many moves beyond the present one are known.
    """
    alone = pieces[0].joints
    if isinstance(alone, SynchronisedJoints):
        return Part(tuple(pieces), pieces[0].stages, _NOTHING, alone.law, over)
    rows = [piece.stages.rows for piece in pieces]
    counts = np.array([len(each) for each in rows])
    stages = Stages(np.concatenate(rows)) if len(rows) > 1 else pieces[0].stages
    return planned_part(pieces, stages, counts, over, look_ahead)


def planned_part(
    pieces: Sequence[Piece], stages: Stages, counts: Counts, over: Overlap | None, look_ahead: int
) -> Part:
    """Return pieces with the time law of stages that count for them instead of their own.

    Args:
        pieces: that are walked together from rest to rest.
        stages: of all pieces in a row.
        counts: how many of them each piece has, one or more, shape (p,).
        over: how they go over into the next ones; None where they stop.
        look_ahead: how many moves beyond the present one are known.
    """
    bounds = np.empty((len(stages), 6))
    bounds[:, :4] = stages.rows
    legs, many = np.array([piece.leg for piece in pieces], np.float64), counts.astype(np.float64)
    lay_horizons(legs, many, look_ahead, bounds)
    return Part(tuple(pieces), stages, counts, plan_stages(bounds, many), over)


def _quickest(pieces: Sequence[Piece], over: Overlap | None, look_ahead: int) -> Part:
    """Return pieces with the bounds of their bends that are walked in the least time."""
    first = part_of(pieces, over, look_ahead)
    most = max(len(piece.gentler) for piece in pieces)
    others = (
        part_of([_gentler(piece, number) for piece in pieces], over, look_ahead) for number in range(most)
    )
    return min((first, *others), key=lambda part: part.law.duration)


def _gentler(piece: Piece, number: int) -> Piece:
    last = len(piece.gentler) - 1
    return piece if last < 0 else replace(piece, stages=piece.gentler[min(number, last)])
