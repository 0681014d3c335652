"""Parts of a stretch, each walked from rest to rest, with their time laws."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.controller.corners import Overlap
from ropsim.controller.pieces import Piece, Walk
from ropsim.motion import Stage, SynchronisedJoints, TimeLaw, plan_time_law
from ropsim.spatial import record


@record
class Part:
    """Pieces that are walked together from rest to rest, and how.

    Attributes:
        pieces: in order.
        law: when the motion is where on them; it counts pieces, whatever the stages of each.
        over: how it goes over into the next one; None where it stops.
    """

    pieces: tuple[Piece, ...]
    law: TimeLaw
    over: Overlap | None

    @property
    def has_stages(self) -> bool:
        """Return whether its time law is planned with stages; else its path is one of time."""
        return bool(self.pieces[0].stages)

    @property
    def leads_tool(self) -> bool:
        """Return whether it is on a path of the tool, so that limits of the tool hold."""
        return self.pieces[0].tool is not None


def parts_of(walks: Sequence[Walk], look_ahead: int) -> tuple[Part, ...]:
    """Return the parts of a stretch between which the arm stops or motions overlap.

    Args:
        walks: the pieces, as from `pieces_of`.
        look_ahead: how many moves beyond the present one are known.
    """
    return tuple(_quickest(pieces, over, look_ahead) for pieces, over in walks)


def part_of(pieces: Sequence[Piece], over: Overlap | None, look_ahead: int) -> Part:
    """Return pieces with their time law: planned stage by stage, told piece by piece.

    Args:
        pieces: that are walked together from rest to rest.
        over: how they go over into the next ones; None where they stop.
        look_ahead: how many moves beyond the present one are known.
    """
    alone = pieces[0].joints
    if isinstance(alone, SynchronisedJoints):
        return Part(tuple(pieces), alone.law, over)
    law = plan_time_law(_with_horizons(pieces, look_ahead))
    counts = [len(piece.stages) for piece in pieces]
    return Part(tuple(pieces), law if max(counts) == 1 else law.in_parts(counts), over)


def _with_horizons(pieces: Sequence[Piece], look_ahead: int) -> list[Stage]:
    """Return the stages of the pieces of a run, with the last stage that is known where a piece ends.

    Within a piece no more gets known: who can stop after it can stop before.
    """
    ends = np.cumsum([len(piece.stages) for piece in pieces]).tolist()
    last = {piece.leg: end - 1 for piece, end in zip(pieces, ends, strict=True)}
    final = pieces[-1].leg
    stages: list[Stage] = []
    for piece in pieces:
        *inner, end = piece.stages
        horizon = last[min(piece.leg + look_ahead, final)]
        stages += (*inner, Stage(end.length, end.speed, end.acceleration, end.jerk, end.ratio, horizon))
    return stages


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
