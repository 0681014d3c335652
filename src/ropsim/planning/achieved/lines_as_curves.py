"""What is said of chains of short lines flown as curves: how far the tool is from the lines at most."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.core import Diagnostic
from ropsim.motion import LINES_AS_CURVE, Line
from ropsim.planning.blends.blend import Blend, CartesianBlend
from ropsim.planning.blends.short_line_chains import chains_of
from ropsim.planning.moves.move_curve import MoveCurve
from ropsim.planning.moves.planned_move import PlannedMove
from ropsim.planning.records.motion_chain import MotionChain
from ropsim.planning.records.wording import passes

_LEAST_SAID = 1e-6
"""Distances [m] and angles [rad] below are not worth saying: on straight lines they are rounding."""
_SHARES = np.linspace(0.0, 1.0, 65)
"""Places on a blend at which it is compared with its lines."""
_WIDEST = 2.0 * math.sqrt(2.0)
"""Norm of the difference of two rotation matrices that are half a turn apart."""


def lines_as_curves(
    chain: MotionChain, moves: Sequence[PlannedMove], blends: Sequence[Blend | None]
) -> list[Diagnostic]:
    """Return M576 for chains of which some lines are flown as curves, unless these are on the lines.

    Args:
        chain: the entities.
        moves: as they are flown.
        blends: between each two of them, as they are flown.
    """
    if not any(move.on_curve for move in moves):
        return []
    found = []
    for first, last in chains_of(chain, moves):
        here = moves[first:last]
        curves = [one.on_curve.curve for one in here if one.on_curve and one.on_curve.is_first]
        if any(max(curve.deviation, curve.turn) > _LEAST_SAID for curve in curves):
            zones = [
                _off_lines(here[k], here[k + 1], blend)
                for k, blend in enumerate(blends[first : last - 1])
                if isinstance(blend, CartesianBlend)
            ]
            found.append(_as_curves(here, curves, zones))
    return found


def _off_lines(before: PlannedMove, behind: PlannedMove, blend: CartesianBlend) -> tuple[float, float]:
    """Return how far a blend is from the nearer one of its two lines at most [m, rad]."""
    lines = [one.tool for one in (before, behind) if isinstance(one.tool, Line)]
    poses = blend.tool.tool(_SHARES * blend.tool.length).matrices
    away, turned = [], []
    for line in lines:
        direction = line.displacement / line.length
        along = (poses[:, :3, 3] - line.X_start.position) @ direction
        nearest = line.tool(np.clip(along, 0.0, line.length)).matrices
        away.append(np.linalg.norm(poses[:, :3, 3] - nearest[:, :3, 3], axis=1))
        apart = np.linalg.norm(poses[:, :3, :3] - nearest[:, :3, :3], axis=(1, 2))  # 2·√2·sin(angle / 2)
        turned.append(2.0 * np.arcsin(np.minimum(apart / _WIDEST, 1.0)))
    owners = np.argmin(away, axis=0), np.arange(len(_SHARES))
    return float(np.array(away)[owners].max()), float(np.array(turned)[owners].max())


def _as_curves(
    moves: Sequence[PlannedMove], curves: Sequence[MoveCurve], zones: Sequence[tuple[float, float]]
) -> Diagnostic:
    """Return M576 for a chain: how many of its lines are flown as curves, and how far the tool is from them.

    Args:
        moves: of the chain.
        curves: that take the place of some of them.
        zones: how far the blends at corners between them are from the lines [m, rad].
    """
    flown, origin = sum(curve.moves for curve in curves), moves[0].move.origin
    deviation, turn = map(max, zip(*((one.deviation, one.turn) for one in curves), *zones, strict=True))
    how = "one curve" if len(curves) == 1 else f"{len(curves)} curves"
    angle = f" and {math.degrees(turn):.2g}°" if turn > _LEAST_SAID else ""
    off = f"at most {max(deviation, _LEAST_SAID) * 1e3:.2g} mm{angle}"
    corners = ", zones at the other corners included" if zones else ""
    return LINES_AS_CURVE.at(
        origin.span,
        f"{flown} of the {len(moves)} lines from here on are flown as {how}, the tool is {off} from the "
        f"lines{corners}",
        label=passes(origin),
        hint="give smaller zones where the tool has to be nearer to the points",
        data={
            "lines": len(moves),
            "flown": flown,
            "curves": len(curves),
            "deviation_m": deviation,
            "turn_rad": turn,
            **origin.data,
        },
    )
