"""Time laws of random ways: bounds, smoothness, look-ahead, and ruckig as the oracle of time."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import ruckig
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from ropsim.motion import Interval, PiecewiseLaw, ProfileLimits, evaluate, plan_profile, plan_time_law
from ropsim.spatial import Array
from support.examples import examples

BOUNDS = 1e-12  # relative; what bounds may be exceeded by
ROUNDING = 1e-9  # relative; polynomials of third degree from rounded times
SAME_TIME = 1e-9  # relative; both are closed forms, ruckig states 1e-8 s for its own tests
GREEDY = 0.23  # relative; by so much `plan_time_law` is slower than need be at most, as it says
NEAR = 1e-2  # relative; a rise is as steep as it can be, which now and then is too early by so much
STEPS = 1e-2  # relative; a motion is levelled off in steps
SPARE = 1e-6  # relative; a way longer by so much than needed is one that ruckig takes without stepping back

sizes = st.floats(-2.0, 2.0).map(lambda exponent: float(10.0**exponent))
wide_sizes = st.floats(-4.0, 4.0).map(lambda exponent: float(10.0**exponent))
ratios = st.one_of(st.just(1.0), st.just(0.0), sizes)
stages = st.builds(Interval, sizes, sizes, sizes, sizes, ratios)
plain_stages = st.builds(Interval, sizes, sizes, sizes, sizes)
alike = st.floats(-0.5, 0.5).map(lambda exponent: float(10.0**exponent))  # up to a factor of 3
wide_stages = st.builds(
    Interval, wide_sizes, wide_sizes, wide_sizes, wide_sizes, st.one_of(ratios, wide_sizes)
)
ways = st.lists(stages, min_size=1, max_size=10)
plain_ways = st.lists(plain_stages, min_size=1, max_size=8)
wide_ways = st.lists(wide_stages, min_size=1, max_size=10)


def _way(v0: float, v1: float, acceleration: float, jerk: float) -> float:
    """Return the least way of a change of speed, written down anew from the law of the S-curve."""
    change = abs(v1 - v0)
    ramp = min(np.sqrt(change / jerk), acceleration / jerk)
    time = ramp + change / (jerk * ramp) if change > 0.0 else 0.0
    return float((v0 + v1) / 2.0 * time)


def _speeds(way: list[Interval], law: PiecewiseLaw) -> tuple[list[float], list[float]]:
    """Return ds/dt at the starts and at the ends of all pieces [1/s], the ends by the ratios."""
    first = np.searchsorted(law.path_segments, np.arange(len(way)))
    starts: list[float] = law.speeds[first].tolist()
    ends = [v / stage.ratio if stage.ratio else 0.0 for v, stage in zip(starts[1:], way[1:], strict=True)]
    return starts, [*ends, 0.0]


def _ruckig_time(v0: float, v1: float, stage: Interval) -> float:
    """Return the least time of a piece between two speeds [s], infinite where ruckig finds none."""
    request = ruckig.InputParameter(1)
    request.current_position, request.target_position = [0.0], [stage.length]
    request.current_velocity, request.target_velocity = [v0], [v1]
    request.max_velocity, request.max_acceleration = [stage.speed], [stage.acceleration]
    request.max_jerk = [stage.jerk]
    oracle = ruckig.Trajectory(1)
    try:
        found = ruckig.Ruckig(1).calculate(request, oracle)
    except RuntimeError:
        return float("inf")
    return float(oracle.duration) if found == ruckig.Result.Working else float("inf")


def _inside(law: PiecewiseLaw, each: int) -> Array:
    """Return times inside of all segments [s], `each` for every one."""
    shares = (np.arange(each) + 0.5) / each
    return np.ravel(law.times[:, None] + law.segments[6][:, None] * shares)


@settings(max_examples=examples(100), derandomize=True)
@given(st.one_of(ways, wide_ways))
def test_bounds_hold_everywhere(way: list[Interval]) -> None:
    law = plan_time_law(way)
    joints = np.concatenate([law.times, law.ends])
    inside = np.concatenate([_inside(law, 20), joints, np.nextafter(joints, 0.0)])
    rows = law.at(inside)
    numbers = [(one.length, one.speed, one.acceleration, one.jerk) for one in way]
    length, speed, acceleration, _ = np.array(numbers)[rows.path_segments].T
    assert (rows.parameters >= 0.0).all()
    assert (rows.parameters <= length).all()
    assert (rows.speeds >= 0.0).all()
    assert (rows.speeds <= speed * (1.0 + ROUNDING)).all()
    assert (np.abs(rows.accelerations) <= acceleration * (1.0 + ROUNDING)).all()
    assert (np.abs(law.jerks) <= np.array(numbers)[law.path_segments, 3]).all()


@settings(max_examples=examples(100), derandomize=True)
@given(st.one_of(ways, wide_ways))
def test_place_speed_and_acceleration_go_on_from_segment_to_segment(way: list[Interval]) -> None:
    law = plan_time_law(way)
    _, times, places, speeds, accelerations, jerks, h, ends = law.segments
    bounds = np.array([(one.length, one.speed, one.acceleration, one.ratio) for one in way])[
        law.path_segments
    ]
    length, speed, acceleration, ratio = bounds.T
    reached = places + h * (speeds + h * (accelerations / 2.0 + h * jerks / 6.0))
    v = speeds + h * (accelerations + h * jerks / 2.0)
    a = accelerations + h * jerks
    assert (np.abs(reached - ends) <= ROUNDING * length).all()
    same = law.path_segments[1:] == law.path_segments[:-1]
    assert (places[1:] == np.where(same, ends[:-1], 0.0)).all()
    assert (ends[:-1][~same] == length[:-1][~same]).all()
    factor = np.where(same, 1.0, ratio[1:])
    assert (
        np.abs(v[:-1] * factor - speeds[1:]) <= ROUNDING * np.maximum(speed[1:], factor * speed[:-1])
    ).all()
    most = np.maximum(acceleration[1:], factor * acceleration[:-1])
    assert (np.abs(a[:-1] * factor - accelerations[1:]) <= ROUNDING * most).all()
    assert (np.abs(a[:-1])[factor == 0.0] <= ROUNDING * acceleration[:-1][factor == 0.0]).all()
    assert speeds[0] == accelerations[0] == places[0] == times[0] == 0.0
    assert abs(v[-1]) <= ROUNDING * speed[-1]
    assert abs(a[-1]) <= ROUNDING * acceleration[-1]
    assert (np.abs(np.append(times[1:], law.duration) - times - h) <= BOUNDS * law.duration).all()
    last = np.append(~same, True)
    assert law.ends.tolist() == np.append(times[1:], law.duration)[last].tolist()


@settings(max_examples=examples(100), derandomize=True)
@given(ways)
def test_the_motion_never_goes_back(way: list[Interval]) -> None:
    law = plan_time_law(way)
    rows = law.at(np.linspace(0.0, law.duration, 2001))
    gone = (
        np.concatenate([[0.0], np.cumsum([one.length for one in way])])[rows.path_segments] + rows.parameters
    )
    assert (np.diff(rows.path_segments) >= 0).all()
    assert (np.diff(gone) >= -BOUNDS * gone[-1]).all()


@settings(max_examples=examples(100), derandomize=True)
@given(wide_sizes, wide_sizes, wide_sizes, wide_sizes)
def test_one_piece_is_the_rest_to_rest_profile(length: float, v: float, a: float, j: float) -> None:
    profile, law = (
        plan_profile(length, ProfileLimits(v, a, j)),
        plan_time_law([Interval(length, v, a, j)]),
    )
    assert abs(law.duration - profile.duration) <= BOUNDS * profile.duration
    t = np.linspace(0.0, profile.duration, 101)
    assert np.abs(law.at(t).parameters - evaluate(profile, t)[0]).max() <= BOUNDS * length


@settings(max_examples=examples(100), derandomize=True)
@given(sizes, sizes, sizes, sizes, st.floats(1.0, 3.0), st.floats(-4.0, 2.0))
def test_a_piece_between_two_speeds_takes_the_time_that_ruckig_finds(
    v0: float, v1: float, a: float, j: float, faster: float, spare: float
) -> None:
    length = (_way(v0, v1, a, j) + max(v0, v1) ** 1.5 / j**0.5 * SPARE) * (1.0 + 10.0**spare)
    piece = Interval(length, max(v0, v1) * faster, a, j)
    before = Interval(2.0 * _way(0.0, v0, a, j), v0, a, j)
    after = Interval(2.0 * _way(0.0, v1, a, j), v1, a, j)
    law = plan_time_law([before, piece, after])
    assert _speeds([before, piece, after], law)[0] == [0.0, v0, v1]
    expected = _ruckig_time(v0, v1, piece)
    assert abs(law.ends[1] - law.ends[0] - expected) <= SAME_TIME * expected + BOUNDS * law.duration


@settings(max_examples=examples(100), derandomize=True)
@given(plain_stages, st.lists(st.floats(0.01, 1.0), min_size=2, max_size=20))
def test_one_line_cut_into_pieces_takes_the_time_of_the_line(whole: Interval, shares: list[float]) -> None:
    lengths = np.array(shares) / sum(shares) * whole.length
    cut = plan_time_law([replace(whole, length=length) for length in lengths.tolist()])
    assert abs(cut.duration - plan_time_law([whole]).duration) <= ROUNDING * cut.duration


@settings(max_examples=examples(200), derandomize=True)
@given(plain_stages, plain_stages, alike, alike)
def test_no_other_speed_where_two_alike_pieces_meet_is_faster(
    first: Interval, second: Interval, more: float, steeper: float
) -> None:
    """Where their accelerations differ more, a lower speed may be; see `plan_time_law`."""
    acceleration, jerk = more * first.acceleration, steeper * first.jerk
    second = replace(second, acceleration=acceleration, jerk=jerk)
    law = plan_time_law([first, second])
    chosen = _speeds([first, second], law)[0][1]
    for v in [*np.linspace(0.0, min(first.speed, second.speed), 40), 0.99 * chosen, 0.999 * chosen]:
        other = _ruckig_time(0.0, float(v), first) + _ruckig_time(float(v), 0.0, second)
        assert law.duration <= other * (1.0 + SAME_TIME)


@settings(max_examples=examples(100), derandomize=True)
@given(plain_ways)
def test_the_way_back_takes_as_long(way: list[Interval]) -> None:
    there, back = plan_time_law(way), plan_time_law(way[::-1])
    assert abs(there.duration - back.duration) <= ROUNDING * there.duration


@settings(max_examples=examples(100), derandomize=True)
@given(plain_ways, st.data())
def test_units_of_the_pieces_do_not_count(way: list[Interval], data: st.DataObject) -> None:
    units = [data.draw(sizes) for _ in way]
    other = [
        Interval(s.length * u, s.speed * u, s.acceleration * u, s.jerk * u, u / before)
        for s, u, before in zip(way, units, [1.0, *units], strict=False)
    ]
    plain, scaled = plan_time_law(way), plan_time_law(other)
    assert np.abs(plain.ends - scaled.ends).max() <= ROUNDING * plain.duration


@settings(max_examples=examples(100), derandomize=True)
@given(ways, st.floats(1.0, 2.0), st.floats(1.0, 2.0), st.floats(1.0, 2.0))
def test_wider_bounds_are_never_slower(way: list[Interval], v: float, a: float, j: float) -> None:
    wider = [replace(s, speed=s.speed * v, acceleration=s.acceleration * a, jerk=s.jerk * j) for s in way]
    assert plan_time_law(wider).duration <= plan_time_law(way).duration * (1.0 + ROUNDING)


@settings(max_examples=examples(200), derandomize=True)
@given(ways, st.data())
def test_one_wider_bound_is_hardly_ever_slower(way: list[Interval], data: st.DataObject) -> None:
    name, one = data.draw(st.sampled_from(["speed", "acceleration", "jerk"])), data.draw(st.integers(0, 9))
    place = one % len(way)
    wider = replace(way[place], **{name: getattr(way[place], name) * data.draw(st.floats(1.0, 2.0))})
    law = plan_time_law([*way[:place], wider, *way[place + 1 :]])
    assert law.duration <= plan_time_law(way).duration * (1.0 + NEAR)


def _levelled(v: float, a: float, way: list[Interval]) -> tuple[float, list[Interval]]:
    """Return the speed at which a is taken back to 0, by steps, and what is left of the pieces then."""
    left, step = list(way), a / way[0].jerk / 2000.0
    while a > 0.0 and left:
        now = min(step, a / left[0].jerk)
        gone = now * (v + a * now / 2.0)
        v, a = v + now * (a - left[0].jerk * now / 2.0), a - left[0].jerk * now
        rest = left[0].length - gone
        left = [replace(left[0], length=rest), *left[1:]] if rest > 0.0 else left[1:]
    return v, left


def _can_stop(v: float, way: list[Interval]) -> bool:
    """Return whether the motion can come to rest over pieces in one unit, found by walking over them.

    It may fall over several pieces at once, with the least of their bounds; between two such falls the
    acceleration is 0. All divisions are tried.
    """
    for count in range(1, len(way) + 1):
        run = way[:count]
        if v > min(one.speed for one in run) * (1.0 + ROUNDING):
            return False
        slower = _least_speed_behind(v, run)
        if slower == 0.0 or _can_stop(slower, way[count:]):
            return True
    return v == 0.0


def _least_speed_behind(v: float, run: list[Interval]) -> float:
    """Return the least speed to which a motion falls over pieces, without acceleration at both ends."""
    length = sum(one.length for one in run) * (1.0 + ROUNDING)
    a, j = min(one.acceleration for one in run), min(one.jerk for one in run)
    if _way(v, 0.0, a, j) <= length:
        return 0.0
    low, high = 0.0, v
    for _ in range(60):
        middle = (low + high) / 2.0
        if _way(v, middle, a, j) <= length:
            high = middle
        else:
            low = middle
    return high


@settings(max_examples=examples(100), derandomize=True)
@given(st.lists(plain_stages, min_size=2, max_size=8), st.data())
def test_the_motion_can_stop_on_what_is_known(way: list[Interval], data: st.DataObject) -> None:
    ahead = [data.draw(st.integers(i, len(way) - 1)) for i in range(len(way))]
    short = [replace(one, horizon=horizon) for one, horizon in zip(way, ahead, strict=True)]
    law = plan_time_law(short)
    rows = law.at(law.ends[:-1])
    for i, (v, a) in enumerate(zip(rows.speeds.tolist(), rows.accelerations.tolist(), strict=True)):
        if a < 0.0:  # it brakes already, later than it could begin to without acceleration
            continue
        if ahead[i] == len(way) - 1:  # it comes to rest there
            continue
        known = way[i + 1 : ahead[i] + 1]
        top, left = _levelled(v, a, known) if known else (v, known)
        assert _can_stop(top * (1.0 - STEPS), left) or v <= ROUNDING * way[i].speed
    assert law.duration >= plan_time_law(way).duration / (1.0 + GREEDY)


@settings(max_examples=examples(100), derandomize=True)
@given(st.lists(plain_stages, min_size=2, max_size=8), st.integers(0, 8))
def test_more_look_ahead_is_never_slower(way: list[Interval], ahead: int) -> None:
    less, more = (
        plan_time_law([replace(one, horizon=i + n) for i, one in enumerate(way)]).duration
        for n in (ahead, ahead + 1)
    )
    assert more <= less * (1.0 + NEAR)


@settings(max_examples=examples(100), derandomize=True)
@given(ways, st.lists(st.floats(0.0, 1.0), min_size=1, max_size=20).map(sorted))
def test_times_of_places_lead_back_to_the_places(way: list[Interval], shares: list[float]) -> None:
    law = plan_time_law(way)
    for piece, one in enumerate(way):
        places = np.array(shares) * one.length
        times = law.times_of(piece, places)
        assert all(before <= after for before, after in pairwise(times.tolist()))
        rows = law.at(times)
        # Where the motion runs fast, a time that is rounded is a place that is rounded.
        slack = BOUNDS * one.length + 4.0 * np.spacing(law.duration) * one.speed
        found = np.where(
            rows.path_segments == piece,
            rows.parameters,
            np.where(rows.path_segments > piece, one.length, 0.0),
        )
        assert (np.abs(found - places) <= slack).all()


@settings(max_examples=examples(50), derandomize=True)
@given(plain_ways)
def test_a_stop_in_the_middle_costs_time(way: list[Interval]) -> None:
    assume(len(way) > 1)
    stopped = [replace(one, ratio=0.0) for one in way]
    alone = sum(plan_time_law([one]).duration for one in way)
    assert abs(plan_time_law(stopped).duration - alone) <= ROUNDING * alone
    assert plan_time_law(way).duration < alone
