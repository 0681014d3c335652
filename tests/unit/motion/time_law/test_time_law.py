"""The time law of a way of several pieces: hand computations, stops, units, look-ahead, places and times."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from types import FunctionType

import numpy as np
import numpy.typing as npt
import pytest

from ropsim.motion import (
    Interval,
    PiecewiseLaw,
    ProfileError,
    ProfileLimits,
    evaluate,
    jerk_limited,
    plan_profile,
    plan_time_law,
)
from ropsim.motion.testing import law_rows_kernel, law_times_kernel, time_law_kernel
from support.in_python import in_python

ROUNDING = 1e-12  # relative; a handful of float64 operations
POWERS = 1e-14  # relative; a library's power may differ from another's in the last bit

SHAPES = {
    "all seven segments": Interval(10.0, 1.0, 2.0, 8.0),
    "speed limit without constant acceleration": Interval(4.0, 1.0, 10.0, 4.0),
    "acceleration limit without constant speed": Interval(1.5, 10.0, 1.0, 2.0),
    "jerk limit only": Interval(1.0, 10.0, 10.0, 32.0),
    "very short": Interval(1e-6, 1e6, 1e6, 1e-6),
    "very long": Interval(1e6, 1e-6, 1e6, 1e6),
}
WAY = (
    Interval(0.3, 0.5, 2.0, 20.0),
    Interval(0.02, 0.2, 2.0, 20.0),
    Interval(1.0, 2.0, 4.0, 90.0, ratio=3.0),
    Interval(0.4, 0.7, 1.0, 5.0, ratio=0.25),
    Interval(2.0, 1.0, 3.0, 30.0, ratio=0.0),
    Interval(0.1, 0.5, 2.0, 20.0),
)


def _rest_to_rest(stage: Interval) -> float:
    limits = ProfileLimits(stage.speed, stage.acceleration, stage.jerk)
    return plan_profile(stage.length, limits).duration


def _speeds_at_ends(law: PiecewiseLaw) -> list[float]:
    """Return ds/dt just after the ends of all pieces but the last [1/s]."""
    speeds: list[float] = law.at(law.ends[:-1]).speeds.tolist()
    return speeds


@pytest.mark.parametrize("stage", SHAPES.values(), ids=SHAPES.keys())
def test_one_piece_alone_has_the_s_curve(stage: Interval) -> None:
    profile = plan_profile(stage.length, ProfileLimits(stage.speed, stage.acceleration, stage.jerk))
    law = plan_time_law([stage])
    assert law.duration == pytest.approx(profile.duration, rel=ROUNDING)
    t = np.linspace(0.0, profile.duration, 101)
    rows, (way, speed, acceleration) = law.at(t), evaluate(profile, t)
    assert rows.parameters == pytest.approx(way, rel=ROUNDING, abs=ROUNDING * stage.length)
    assert rows.speeds == pytest.approx(speed, rel=ROUNDING, abs=ROUNDING * profile.peak_speed)
    peak = profile.peak_acceleration
    assert rows.accelerations == pytest.approx(acceleration, rel=ROUNDING, abs=ROUNDING * peak)


def test_two_pieces_share_the_s_curve_of_both_where_only_jerk_limits() -> None:
    # In its middle a rest-to-rest S-curve has no acceleration; over 2 with unit jerk it takes (32·2)^(1/3) s
    law = plan_time_law([Interval(1.0, 10.0, 10.0, 1.0)] * 2)
    assert law.duration == pytest.approx(4.0, rel=ROUNDING)
    assert law.ends.tolist() == pytest.approx([2.0, 4.0], rel=ROUNDING)
    assert _speeds_at_ends(law) == pytest.approx([1.0], rel=ROUNDING)


def test_speed_rises_over_a_piece_as_far_as_a_hand_computation_says() -> None:
    # For a = 1, j = 1: after 1 s speed 1/2 and way 1/6; then 2 s at a = 1 lead over 1/2·2 + 2 = 3
    law = plan_time_law([Interval(3.0 + 1.0 / 6.0, 10.0, 1.0, 1.0), Interval(1000.0, 10.0, 1.0, 1.0)])
    assert _speeds_at_ends(law) == pytest.approx([2.5], rel=ROUNDING)
    assert law.ends[0] == pytest.approx(3.0, rel=ROUNDING)
    assert law.at(law.ends[:1]).accelerations.tolist() == pytest.approx([1.0], rel=ROUNDING)


def test_the_acceleration_is_taken_back_before_a_piece_that_bounds_it() -> None:
    law = plan_time_law([Interval(x, 100.0, a, 8.0) for x, a in ((20.0, 4.0), (20.0, 0.5), (90.0, 4.0))])
    first, second = law.at(law.ends[:-1]).accelerations
    assert first == pytest.approx(0.5, rel=ROUNDING)
    assert abs(second) <= 0.5 * (1.0 + ROUNDING)
    assert np.abs(law.accelerations[law.path_segments == 1]).max() <= 0.5 * (1.0 + ROUNDING)


def test_the_slower_piece_bounds_the_speed_where_two_meet() -> None:
    law = plan_time_law(
        [
            Interval(10.0, 1.0, 2.0, 8.0),
            Interval(10.0, 0.25, 2.0, 8.0),
            Interval(10.0, 1.0, 2.0, 8.0),
        ]
    )
    assert _speeds_at_ends(law) == pytest.approx([0.25, 0.25], rel=ROUNDING)
    assert law.ends[1] - law.ends[0] == pytest.approx(40.0, rel=ROUNDING)


def test_a_ratio_carries_the_speed_into_the_unit_of_the_next_piece() -> None:
    law = plan_time_law([Interval(10.0, 1.0, 2.0, 8.0), Interval(10.0, 9.0, 20.0, 80.0, ratio=3.0)])
    just_before = law.at([np.nextafter(law.ends[0], 0.0)])
    assert just_before.path_segments.tolist() == [0]
    assert just_before.speeds[0] == pytest.approx(1.0, rel=ROUNDING)
    assert _speeds_at_ends(law) == pytest.approx([3.0], rel=ROUNDING)


def test_the_motion_stops_at_a_ratio_of_zero() -> None:
    first, second = SHAPES["all seven segments"], SHAPES["jerk limit only"]
    law = plan_time_law([first, replace(second, ratio=0.0)])
    assert _speeds_at_ends(law) == [0.0]
    assert law.duration == pytest.approx(_rest_to_rest(first) + _rest_to_rest(second), rel=ROUNDING)


def test_a_cut_where_the_speed_is_constant_changes_nothing() -> None:
    whole = Interval(10.0, 1.0, 2.0, 8.0)
    parts = [replace(whole, length=length) for length in (4.0, 1.0, 5.0)]
    assert plan_time_law(parts).duration == pytest.approx(plan_time_law([whole]).duration, rel=ROUNDING)


def test_without_look_ahead_every_piece_ends_at_rest() -> None:
    law = plan_time_law([replace(stage, horizon=i) for i, stage in enumerate(WAY)])
    assert _speeds_at_ends(law) == [0.0] * (len(WAY) - 1)
    assert law.duration == pytest.approx(sum(map(_rest_to_rest, WAY)), rel=ROUNDING)


def test_a_look_ahead_of_one_piece_lets_the_motion_stop_on_the_next() -> None:
    # v²/(2a) + v·a/(2j) = 3 for a = 1, j = 1 is v² + v = 6: to rest over 3 from 2 1/s, though the way goes on
    stage = Interval(3.0, 10.0, 1.0, 1.0)
    law = plan_time_law([replace(stage, horizon=i + 1) for i in range(6)])
    assert max(_speeds_at_ends(law)[:-1]) <= 2.0 * (1.0 + ROUNDING)
    assert _speeds_at_ends(law)[:4] == pytest.approx([2.0] * 4, rel=ROUNDING)
    assert plan_time_law([stage] * 6).duration < law.duration


@pytest.mark.parametrize("pieces", [1, 4, 40])
def test_a_look_ahead_counts_by_its_length_not_by_its_pieces(pieces: int) -> None:
    """The way of one piece, of which the motion stops on two thirds: v²/(2a) + v·a/(2j) = 3 from 2 1/s."""
    stage = Interval(3.0 / pieces, 2.0, 1.0, 1.0)
    many, ahead = 12 * pieces, pieces + (pieces + 1) // 2
    law = plan_time_law([replace(stage, horizon=i + ahead) for i in range(many)])
    whole = plan_time_law([Interval(36.0, 2.0, 1.0, 1.0)])
    assert whole.duration * (1.0 - ROUNDING) <= law.duration <= 1.001 * whole.duration


def test_a_look_ahead_lets_no_rise_begin_faster_than_the_one_before_ends() -> None:
    """Falls to rest kept to bounds that such falls had lowered: the speed stepped from 1.56 to 1.66 1/s."""
    law = plan_time_law(
        [
            Interval(2.0, 2.0, 1.0, 1.0, horizon=3),
            Interval(0.5, 2.0, 1.0, 8.0, horizon=3),
            Interval(1.0, 1.5, 4.0, 2.0, horizon=3),
            Interval(0.25, 3.0, 2.0, 16.0, horizon=3),
            Interval(3.0, 2.0, 1.0, 1.0),
        ]
    )
    _, _, _, v, a, j, h, _ = law.segments
    ends = v + h * (a + 0.5 * h * j)
    assert ends == pytest.approx(np.append(v[1:], 0.0), rel=ROUNDING, abs=ROUNDING)


@pytest.mark.parametrize("ahead", [len(WAY) - 1, len(WAY), 1000])
def test_a_look_ahead_over_the_whole_way_is_none(ahead: int) -> None:
    law = plan_time_law([replace(stage, horizon=i + ahead) for i, stage in enumerate(WAY)])
    assert law == plan_time_law(WAY)


def test_the_nearest_parameter_above_the_start_takes_no_time() -> None:
    law = plan_time_law([Interval(1.0, 1.0, 1.0, 100.0)])
    assert law.times_of(0, [math.ulp(0.0)]).tolist() == [0.0]


def test_start_and_end_are_exact_and_the_motion_rests_outside() -> None:
    law = plan_time_law(WAY)
    rows = law.at([-1.0, 0.0, law.duration, law.duration + 1.0, math.inf])
    assert rows.path_segments.tolist() == [0, 0, 5, 5, 5]
    assert rows.parameters.tolist() == [0.0, 0.0, 0.1, 0.1, 0.1]
    assert rows.speeds.tolist() == rows.accelerations.tolist() == [0.0] * 5


def test_the_next_piece_has_begun_where_one_ends() -> None:
    law = plan_time_law(WAY)
    rows = law.at(law.ends[:-1])
    assert rows.path_segments.tolist() == [1, 2, 3, 4, 5]
    assert rows.parameters.tolist() == rows.accelerations.tolist() == [0.0] * 5
    assert law.at(np.nextafter(law.ends, 0.0)).parameters == pytest.approx([one.length for one in WAY])


def test_no_time_is_no_row_and_a_time_that_is_no_number_has_no_place() -> None:
    law = plan_time_law(WAY)
    assert law.at([]).parameters.shape == (0,)
    assert np.isnan(law.at([math.nan]).parameters).all()
    assert np.isnan(law.times_of(0, [math.nan])).all()


def test_segments_follow_each_other_in_time_and_in_order_of_the_pieces() -> None:
    law = plan_time_law(WAY)
    assert law.times[0] == 0.0
    assert all(before < after for before, after in pairwise([*law.times.tolist(), law.duration]))
    assert sorted(law.path_segments.tolist()) == law.path_segments.tolist()
    assert set(law.path_segments.tolist()) == set(range(len(WAY)))
    rows = law.at(law.times)
    for found, stored in (
        (rows.parameters, law.parameters),
        (rows.speeds, law.speeds),
        (rows.accelerations, law.accelerations),
    ):
        assert found.tolist() == stored.tolist()
    assert np.diff(law.times)[:-1] == pytest.approx(law.segments[6, :-2], rel=ROUNDING, abs=ROUNDING)


@pytest.mark.parametrize("unit", [1.0, 2.6899601290682327, 3.055062319799821])
def test_a_speed_that_could_rise_by_less_than_its_last_digit_fits_the_way(unit: float) -> None:
    # A rise by d from 1000 1/s takes the way 2000·√(d/jerk): over 1, d is about 1e-13, the last digit of 1000
    for speed in np.random.default_rng(6).uniform(500.0, 1000.0, 40).tolist():
        for jerk in np.logspace(-9.0, -6.0, 8).tolist():
            slow = Interval(1e4, speed, 1e6, 1e9, 1.0 / unit)
            fast, short = replace(slow, speed=2e3), Interval(unit, 2e3 * unit, unit, jerk * unit, unit)
            for way in ([slow, short, fast], [fast, short, slow]):
                law = plan_time_law(way)
                _, _, places, speeds, accelerations, jerks, h, ends = law.segments
                reached = places + h * (speeds + h * (accelerations / 2.0 + h * jerks / 6.0))
                np.testing.assert_allclose(reached, ends, rtol=ROUNDING)
                assert abs((law.ends[1] - law.ends[0]) * speed - 1.0) <= 1e-9


def test_bounds_hold_where_a_piece_takes_no_longer_than_the_last_digit_of_the_time() -> None:
    # After 1e9 s the next number is 1.2e-7 s later
    short = [Interval(10.0**k, 1e3, 1e3, 1e12) for k in range(-12, -3)]
    law = plan_time_law([Interval(1e6, 1e-3, 1.0, 1.0), *(replace(one, ratio=0.0) for one in short)])
    assert law.ends[0] > 1e9
    times = law.ends[0] + np.spacing(law.ends[0]) * np.arange(20_000)
    rows = law.at(times)
    assert len(set(rows.path_segments.tolist())) >= 5
    assert np.abs(rows.accelerations).max() <= 1e3 * (1.0 + ROUNDING)


def test_times_in_any_order_give_the_rows_of_times_in_order() -> None:
    law = plan_time_law(WAY)
    t = np.linspace(0.0, law.duration, 300)
    order = np.random.default_rng(2).permutation(len(t))
    assert law.at(t[order]).parameters.tolist() == law.at(t).parameters[order].tolist()


@pytest.mark.parametrize("piece", range(len(WAY)))
def test_times_of_places_are_those_at_which_the_motion_is_there(piece: int) -> None:
    law = plan_time_law(WAY)
    places = np.linspace(0.0, WAY[piece].length, 200)[1:-1]
    times = law.times_of(piece, places)
    rows = law.at(times)
    assert (rows.path_segments == piece).all()
    assert rows.parameters == pytest.approx(places, rel=ROUNDING)
    assert (np.diff(times) > 0.0).all()


def told_over(stages: Sequence[Interval], counts: npt.ArrayLike) -> PiecewiseLaw:
    """Return the time law of stages, told over pieces of so many of them."""
    rows = [(one.length, one.speed, one.acceleration, one.jerk, one.ratio, one.horizon) for one in stages]
    return jerk_limited(np.array(rows, np.float64), np.array(counts, np.float64))


def test_told_in_longer_parts_it_is_the_same_motion() -> None:
    law = plan_time_law([replace(one, ratio=1.0) for one in WAY])
    parts = told_over([replace(one, ratio=1.0) for one in WAY], [1, 3, 2])
    t = np.linspace(0.0, law.duration, 1001)
    rows, told = law.at(t), parts.at(t)
    lengths = [one.length for one in WAY]
    before = np.array([0.0, 0.0, lengths[1], lengths[1] + lengths[2], 0.0, lengths[4]])
    assert told.path_segments.tolist() == np.array([0, 1, 1, 1, 2, 2])[rows.path_segments].tolist()
    np.testing.assert_allclose(told.parameters, rows.parameters + before[rows.path_segments], rtol=ROUNDING)
    assert (told.speeds == rows.speeds).all()
    assert (told.accelerations == rows.accelerations).all()
    assert parts.ends.tolist() == law.ends[[0, 3, 5]].tolist()
    assert parts.times_of(1, [lengths[1]])[0] == pytest.approx(law.ends[1], rel=ROUNDING)


@pytest.mark.parametrize("seed", range(20))
def test_over_longer_pieces_places_are_counted_from_the_first_of_each(seed: int) -> None:
    rng = np.random.default_rng(seed)
    many = rng.integers(1, 5, 5)
    rows = rng.uniform((0.02, 0.5, 2.0, 40.0), (0.3, 1.5, 6.0, 200.0), (int(many.sum()), 4))
    stages = [Interval(*row) for row in rows.tolist()]
    law, longer = plan_time_law(stages), told_over(stages, many)
    firsts = np.append(0, np.cumsum(many[:-1]))
    ends = np.cumsum(rows[:, 0])
    begins = np.append(0.0, ends[:-1]) - np.repeat(np.append(0.0, ends)[firsts], many)
    assert longer.path_segments.tolist() == np.repeat(np.arange(5), many)[law.path_segments].tolist()
    assert longer.parameters == pytest.approx(
        law.parameters + begins[law.path_segments], rel=ROUNDING, abs=ROUNDING
    )
    assert longer.segments[7] == pytest.approx(law.segments[7] + begins[law.path_segments], rel=ROUNDING)
    assert longer.ends.tolist() == law.ends[np.cumsum(many) - 1].tolist()
    assert longer.segments[[1, 3, 4, 5, 6]].tolist() == law.segments[[1, 3, 4, 5, 6]].tolist()


@pytest.mark.parametrize("piece", range(len(WAY)))
def test_the_time_of_one_place_is_that_of_it_among_others(piece: int) -> None:
    law = plan_time_law(WAY)
    places = np.linspace(-0.1, 1.2, 30)
    alone = [law.time_of(piece, place) for place in places.tolist()]
    assert alone == law.times_of(piece, places).tolist()
    assert alone == law.times_of(piece, places[::-1])[::-1].tolist()


@pytest.mark.parametrize("seed", range(20))
def test_the_times_of_places_in_order_are_those_of_each_but_for_rounding(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows = rng.uniform((0.02, 0.5, 2.0, 40.0), (0.3, 1.5, 6.0, 200.0), (6, 4))
    law = told_over([Interval(*row) for row in rows.tolist()], [1, 3, 2])
    lengths = np.array([rows[0, 0], rows[1:4, 0].sum(), rows[4:, 0].sum()])
    pieces = np.sort(rng.integers(0, 3, 60)).astype(np.float64)
    places = rng.uniform(-0.1, 1.1, 60) * lengths[pieces.astype(int)]
    places[rng.integers(0, 60, 10)] = 0.0
    order = np.lexsort((places, pieces))
    pieces, places, out = pieces[order], places[order], np.empty(60)
    law_times_kernel.times_along(law.segments, law.ends, pieces, places, out)
    wanted = law.times_of(pieces, places)
    inside = (places >= 0.0) | (pieces == 0.0)
    assert out[inside] == pytest.approx(wanted[inside], rel=1e-12, abs=1e-14)
    assert out[~inside] == pytest.approx(wanted[~inside], rel=1e-12)


def test_a_piece_that_no_motion_can_have_is_refused_with_its_bounds() -> None:
    with pytest.raises(ProfileError, match=r"length 0\.7, speed nan"):
        plan_time_law([Interval(0.7, math.nan, 1.0, 1.0)])


def test_times_of_places_beyond_the_ends_are_those_of_the_ends() -> None:
    law = plan_time_law(WAY)
    assert law.times_of(0, [-1.0, 0.0]).tolist() == [0.0, 0.0]
    assert law.times_of(2, [-1.0, 0.0]).tolist() == [law.ends[1]] * 2
    assert law.times_of(2, [1.0, 7.0]).tolist() == [law.ends[2]] * 2


def test_times_of_places_near_to_rest_follow_the_cube_root() -> None:
    law = plan_time_law([Interval(1.0, 10.0, 10.0, 32.0)])  # s = 32/6·t³ at first, at its end mirrored
    near = np.array([1e-15, 1e-9, 1e-3])
    after = np.cbrt(near * 6.0 / 32.0)
    assert law.times_of(0, near) == pytest.approx(after, rel=ROUNDING)
    assert law.times_of(0, 1.0 - near[1:]) == pytest.approx(law.duration - after[1:], abs=1e-10)


def test_times_of_places_on_several_pieces_are_those_of_each_piece_alone() -> None:
    law, places = plan_time_law(WAY), np.linspace(0.0, 1.0, 5)
    numbers = [2, 2, 0, 5, 3]
    alone = [law.times_of(number, [place])[0] for number, place in zip(numbers, places, strict=True)]
    assert law.times_of(numbers, places).tolist() == alone


@pytest.mark.parametrize("piece", [-1, len(WAY)])
def test_there_are_no_places_on_a_piece_that_is_not_there(piece: int) -> None:
    with pytest.raises(IndexError, match=f"path segment {piece} of 6"):
        plan_time_law(WAY).times_of(piece, [0.0])


@pytest.mark.parametrize(("place", "name"), [(0, "length"), (1, "speed"), (2, "acceleration"), (3, "jerk")])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_bound_that_no_motion_can_have_is_refused_with_its_piece(
    place: int, name: str, value: float
) -> None:
    good = Interval(1.0, 1.0, 1.0, 1.0)
    length, speed, acceleration, jerk = (value if number == place else 1.0 for number in range(4))
    bad = Interval(length, speed, acceleration, jerk)
    with pytest.raises(ProfileError, match=f"path segment 2 has .*{name} {value:g}"):
        plan_time_law([good, good, bad])


@pytest.mark.parametrize(
    "bad",
    [Interval(1.0, 1.0, 1.0, 1.0, ratio) for ratio in (-1.0, math.nan, math.inf)]
    + [Interval(1.0, 1.0, 1.0, 1.0, 1.0, horizon) for horizon in (0, -2)],
)
def test_a_ratio_or_horizon_that_says_nothing_is_refused(bad: Interval) -> None:
    with pytest.raises(ProfileError, match="path segment 1 has"):
        plan_time_law([Interval(1.0, 1.0, 1.0, 1.0), bad])


def test_a_way_without_pieces_is_refused() -> None:
    with pytest.raises(ProfileError, match="no segments"):
        plan_time_law([])


def test_numbers_as_far_apart_as_allowed_give_a_finite_motion() -> None:
    for k in range(16):
        length, speed, acceleration, jerk = ((1e-50, 1e50)[k >> bit & 1] for bit in range(4))
        stage = Interval(length, speed, acceleration, jerk)
        law = plan_time_law([stage] * 3)
        assert np.isfinite(law.segments).all()
        assert 0.0 < law.duration < math.inf
        assert law.at([law.duration]).parameters.tolist() == [length]
    unit = Interval(1.0, 1.0, 1.0, 1.0)
    for way in (
        [Interval(1e51, 1.0, 1.0, 1.0)],
        [unit, Interval(1e50, 1e50, 1e50, 1e50, ratio=1e-50)],
    ):
        with pytest.raises(ProfileError, match="allowed are numbers from 1e-50 to 1e"):
            plan_time_law(way)


def test_ten_thousand_pieces_end_where_they_should() -> None:
    lengths = np.random.default_rng(4).uniform(1e-3, 1.0, 10_000).tolist()
    stages = [Interval(length, 1.0, 5.0, 50.0, horizon=i + 20) for i, length in enumerate(lengths)]
    law = plan_time_law(stages)
    rows = law.at(np.nextafter(law.ends, 0.0))
    assert rows.path_segments.tolist() == list(range(10_000))
    assert rows.parameters == pytest.approx(lengths, rel=1e-9)
    assert law.speeds.max() <= 1.0 + ROUNDING
    assert sum(lengths) < law.duration < sum(map(_rest_to_rest, stages))


def test_compiled_or_not_the_motion_is_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    compiled = plan_time_law(WAY)
    t = np.linspace(0.0, compiled.duration, 50)
    rows, times = compiled.at(t), compiled.times_of(2, np.linspace(0.0, 1.0, 20))
    for module, name in (
        (time_law_kernel, "plan_segments"),
        (law_rows_kernel, "rows_at"),
        (law_times_kernel, "times_at"),
    ):
        plain = in_python(getattr(module, name))
        assert isinstance(plain, FunctionType)
        monkeypatch.setattr(module, name, plain)
    law = plan_time_law(WAY)
    np.testing.assert_allclose(law.segments, compiled.segments, rtol=POWERS, atol=POWERS)
    np.testing.assert_allclose(law.at(t).parameters, rows.parameters, rtol=POWERS, atol=POWERS)
    np.testing.assert_allclose(law.times_of(2, np.linspace(0.0, 1.0, 20)), times, rtol=POWERS)
