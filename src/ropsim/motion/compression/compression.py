"""Compression: which moves of a chain become curves, which stay lines, and which points keep their blend."""

from enum import Enum

import numpy as np

from ropsim.motion.compression.chain import Chain, chain_of, refused
from ropsim.motion.compression.fitted_curve import FittedCurve, curve_of
from ropsim.motion.compression.run import Run, joins_line, polyline_of, run_of
from ropsim.motion.compression.spline_fit import SplineFit, spline_fit
from ropsim.motion.compression.tolerances import Flags, Numbers, Sharp, sharp_points, tolerances
from ropsim.motion.paths.curve import Curve
from ropsim.spatial import Array, record

_ATTEMPTS = 16
"""Times that runs are fitted anew with wider tolerances or fewer moves, before all their points break."""
_TRIES = 3
"""Times that runs with a curve are fitted anew to follow less noise."""
_NEAR = 2
"""Points around a move without a curve whose tolerances are widened."""
_NOISY, _MANY = 1.01, 8
"""Spans of at most this share of a move in this number of moves one after the other follow noise."""
_WHOLE = 0.25
"""Share of a run; where more of it follows noise all its tolerances are widened."""
_FEW = 0.05
"""Points by moves; where fewer keep their blend a curve that follows noise is given up."""
_Pair = tuple[int, int]
_Made = tuple[SplineFit, FittedCurve]


class BreakCause(Enum):
    """Why a point keeps its own blend."""

    TURN = "the path turns sharply there"
    ODD = "the path turns far more there than next to it"
    TOLERANCE = "there is no curve within the tolerance"


@record
class StraightPart:
    """A move that stays a straight line.

    Attributes:
        number: of the move, 0 for that from point 0 to point 1.
        begin: length at its beginning that belongs to the curve before it [m]; 0 where it keeps its own blend
            or stop.
        end: length at its end that belongs to the curve behind it [m].
    """

    number: int
    begin: float
    end: float


@record
class CurvePart:
    """Moves first .. last - 1, from point `first` to point `last`, as one curve.

    Attributes:
        first: number of the first point.
        last: number of the last point.
        curve: of position and orientation, in the frame of the points. Where the line before or behind stays
            straight and their common point does not keep its blend, it begins or ends on this line, in its
            direction, without curvature; else exactly at the point.
        parameters: path parameters of the curve (arc length [m]) at the points first .. last, rising, shape
            (last - first + 1,); the first is above 0 where the curve begins on the line before, and the last
            one below the length of the curve where it ends on the line behind.
        deviation: greatest distance of the curve from the polyline [m].
        turn: greatest angle between the orientations on the curve and on the polyline at the same share of a
            move [rad].
    """

    first: int
    last: int
    curve: Curve
    parameters: Array
    deviation: float
    turn: float


@record
class Compression:
    """A chain of straight moves as lines and curves.

    Attributes:
        parts: in order. Where the common point of two parts is not on a curve, it keeps its own blend.
        breaks: points that keep their own blend and why, in order. The point between two straight moves is
            one of them where a turn or the tolerance is the cause, not where both are longer than `longest`.
    """

    parts: tuple[StraightPart | CurvePart, ...]
    breaks: tuple[tuple[int, BreakCause], ...]


def compressed(points: Array, rotations: Array, zones: Array, longest: float) -> Compression:
    """Return straight moves with zones as curves of least jerk within tolerances, and lines between them.

    Position and unit quaternion are splines of degree five over the length of the polyline. They minimise the
    integral of the squared third derivative plus weighted squares of the deviations at every point and in the
    middle of every move; weights and breakpoints are adapted until the tolerances hold. The tolerance of a
    point is the deviation that its blend would leave with the zone taken over several moves; where that
    leaves no curve, the distance of the point from the straight path through the zone (`tolerances`).
    Orientation keeps within 0.1° per mm of the zone. All curves are checked at ten steps of each move with
    bounds between them; one that exceeds a tolerance is fitted closer, and at last the point keeps its own
    blend. Where a smooth polyline needs less room than its zones leave, the curve does not use it.

    Args:
        points: ends of the moves, at least `SHORTEST_MOVE` apart [m], shape (k + 1, 3).
        rotations: orientations of the tool there, shape (k + 1, 3, 3).
        zones: of the points between moves, as programmed, all above 0 [m], shape (k - 1,).
        longest: moves that are longer stay lines [m], above 0; about the braking distance.

    Raises:
        ProfileError: M540, where an argument is not as stated, or a number is not finite.

    References:
        Eilers and Marx 1996, Flexible smoothing with B-splines and penalties, Statistical Science 11(2),
        89-121, for least squares with a penalty; Lawson 1961, Contributions to the theory of linear least
        maximum approximation, for weights that grow where a bound is exceeded.
    """
    arrays = (np.array(one, dtype=np.float64) for one in (points, rotations, zones))
    chain = chain_of(*arrays)
    if not longest > 0.0:
        raise refused(f"the longest move is {longest:g} m", "lengths above 0")
    return _compression(chain, longest)


def _compression(chain: Chain, longest: float) -> Compression:
    last = len(chain.lengths)
    sharp = sharp_points(chain)
    is_sharp = sharp != Sharp.NOT
    allowed = tolerances(chain, is_sharp, np.zeros(last + 1, np.bool_), longest)
    straight, broken = allowed.straight, np.zeros(last + 1, np.bool_)
    broken[1:-1] = is_sharp
    curves: list[_Made] = []
    narrow: dict[int, _Made] = {}
    waiting, attempt = _spans(straight, broken, 0, last), 0
    while waiting:
        wide, waiting_next = allowed.wide.copy(), []
        for first, end in waiting:
            run = run_of(chain, straight, broken, first, end)
            tried = spline_fit(polyline_of(chain, allowed, run))
            made = curve_of(tried, chain.rotations[first])
            ratios = _ratios(tried, made)
            holds = made is not None and ratios.max() <= 1.0
            best = narrow.pop(first, None)
            if made is not None and holds and (best is None or len(tried.breaks) < len(best[0].breaks)):
                best = tried, made
            again, worst = _widen_noisy(tried, wide) if holds else _widen_exceeded(run, ratios, wide)
            few = not holds and not again and len(worst) <= _FEW * (end - first)
            if best is None or (few and attempt < _TRIES):
                _break(chain, run, worst, broken)
                if attempt >= _ATTEMPTS:
                    broken[max(first, 1) : min(end, last - 1) + 1] = True
                waiting_next += _spans(straight, broken, first, end)
            elif again and attempt < _TRIES:
                narrow[first] = best
                waiting_next.append((first, end))
            else:
                curves.append(best)
        allowed = tolerances(chain, is_sharp, wide, longest)
        waiting, attempt = waiting_next, attempt + 1
    curves.sort(key=lambda one: one[0].line.run.first)
    parts = _parts(last, curves)
    return Compression(parts, _breaks(chain, longest, sharp, broken, parts))


def _spans(straight: Flags, broken: Flags, first: int, last: int) -> list[_Pair]:
    """Return the first and last points of the runs from one point to another.

    A single move between two points that keep their own blend is none, nor is a straight one.
    """
    found, begin = [], first
    for point in range(first + 1, last + 1):
        if straight[point - 1]:
            begin = point
        elif point == last or broken[point] or straight[point]:
            before = joins_line(straight, broken, begin, begin - 1)
            if point - begin > 1 or before or joins_line(straight, broken, point, point):
                found.append((begin, point))
            begin = point
    return found


def _ratios(tried: SplineFit, made: FittedCurve | None) -> Array:
    """Return the deviations in position and orientation by their tolerances, for each move of its run."""
    ratios = tried.ratios.copy()
    if made is None:
        ratios[np.argmax(ratios[:, 0]), 0] = np.inf
    else:
        ratios[:, 1] = np.maximum(ratios[:, 1], made.turns / tried.line.orientation)
    return ratios


def _widen_exceeded(run: Run, ratios: Array, wide: Flags) -> tuple[bool, list[int]]:
    """Widen the tolerances around moves where they are exceeded.

    Returns:
        whether a tolerance is widened; and the worst move of each group whose tolerances are wide already.
    """
    found, worst, offset = False, [], run.first - (1 if run.before else 0)
    for begin, end in _groups(ratios.max(axis=1) > 1.0):
        around = _around(run, offset + begin, offset + end)
        if (ratios[begin:end, 0] > 1.0).any() and not wide[around].all():
            wide[around] = found = True
        else:
            worst.append(offset + begin + int(np.argmax(ratios[begin:end].max(axis=1))))
    return found, worst


def _widen_noisy(tried: SplineFit, wide: Flags) -> tuple[bool, list[int]]:
    """Widen the tolerances where a spline has a span for each of many moves: it follows noise there.

    Returns:
        as for `_widen_exceeded`; there is no worst move.
    """
    line = tried.line
    middles = 0.5 * (line.ends[:-1] + line.ends[1:])
    spans = np.diff(tried.breaks)[np.searchsorted(tried.breaks, middles, side="right") - 1]
    run, offset = line.run, line.run.first - (1 if line.run.before else 0)
    noisy = [one for one in _groups(spans <= _NOISY * np.diff(line.ends)) if one[1] - one[0] >= _MANY]
    if sum(end - begin for begin, end in noisy) > _WHOLE * len(middles):
        noisy = [(0, len(middles))]
    found = False
    for begin, end in noisy:
        around = _around(run, offset + begin - _MANY, offset + end + _MANY)
        found |= not wide[around].all()
        wide[around] = True
    return found, []


def _break(chain: Chain, run: Run, moves: list[int], broken: Flags) -> None:
    """Let a point of each of these moves keep its blend, the one that bends more."""
    for move in moves:
        ends = [point for point in (move, move + 1) if run.first < point < run.last]
        if not ends:
            ends = [run.first] if run.before else []
            ends += [run.last] if run.behind else []
        broken[max(ends, key=lambda point: _bend(chain, point))] = True


def _groups(flags: Flags) -> list[_Pair]:
    """Return where groups of true values begin, and behind their ends."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], flags.astype(np.int64), [0])))).tolist()
    return list(zip(edges[::2], edges[1::2], strict=True))


def _around(run: Run, first: int, last: int) -> slice:
    """Return the points first .. last and some next to them that belong to a run."""
    return slice(max(first - _NEAR, run.first), min(last + _NEAR, run.last) + 1)


def _bend(chain: Chain, point: int) -> float:
    """Return by which angle direction or orientation change at a point between moves [rad]."""
    length = 0.5 * (chain.lengths[point - 1] + chain.lengths[point])
    return float(max(chain.turns[point - 1], chain.turn_changes[point - 1] * length))


def _parts(moves: int, curves: list[_Made]) -> tuple[StraightPart | CurvePart, ...]:
    """Return curves in order and the straight moves between them."""
    begins, ends = np.zeros(moves), np.zeros(moves)
    for tried, _ in curves:
        run = tried.line.run
        if run.before:
            ends[run.first - 1] = run.before
        if run.behind:
            begins[run.last] = run.behind
    parts: list[StraightPart | CurvePart] = []
    move = 0
    for tried, made in curves:
        run = tried.line.run
        parts += [StraightPart(k, float(begins[k]), float(ends[k])) for k in range(move, run.first)]
        turn = float(made.turns.max())
        parts.append(CurvePart(run.first, run.last, made.curve, made.parameters, tried.deviation, turn))
        move = run.last
    parts += [StraightPart(k, float(begins[k]), float(ends[k])) for k in range(move, moves)]
    return tuple(parts)


def _breaks(
    chain: Chain, longest: float, sharp: Numbers, broken: Flags, parts: tuple[StraightPart | CurvePart, ...]
) -> tuple[tuple[int, BreakCause], ...]:
    """Return the points that keep their own blend for the sake of a turn or the tolerance."""
    alone = np.zeros(len(chain.lengths), np.bool_)
    alone[[part.number for part in parts if isinstance(part, StraightPart)]] = True
    short = chain.lengths <= longest
    found = []
    for point in range(1, len(chain.lengths)):
        cause = _CAUSES[Sharp(int(sharp[point - 1]))]
        between_lines = alone[point - 1] and alone[point] and (short[point - 1] or short[point])
        if cause is not None:
            found.append((point, cause))
        elif broken[point] or between_lines:
            found.append((point, BreakCause.TOLERANCE))
    return tuple(found)


_CAUSES = {Sharp.NOT: None, Sharp.TURN: BreakCause.TURN, Sharp.ODD: BreakCause.ODD}
