"""Paths: what it costs to make one and to be told fifty places of it."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from measuring import Measure, processor_seconds
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, RotationSpline

from ropsim.motion import (
    Arc,
    Curve,
    Line,
    OrientationMode,
    SampledPath,
    arc,
    blend_curve,
    leave,
    spline,
)
from ropsim.spatial import Pose

RNG = np.random.default_rng(3)
PLACES = 50
ROWS = RNG.normal(size=(60, 6)).cumsum(axis=0)
TRACED = SampledPath(1.0, ROWS)


def pose(x: float, y: float) -> Pose:
    """Return a pose on the floor, turned anyhow."""
    return Pose(np.array([x, y, 0.0]), RNG.normal(size=4))


START, MEET, END = pose(0.0, 0.0), pose(1.0, 0.0), pose(1.0, 1.0)
FIRST, SECOND = Line(START, MEET, OrientationMode.DRIVE_TRANSFORM), Line(MEET, END)
MAKERS: dict[str, Callable[[], object]] = {
    "line": lambda: Line(START, MEET),
    "arc": lambda: arc(START, MEET, END),
    "corner": lambda: blend_curve(FIRST, 0.8, SECOND, 0.2),
    "spline of three points": lambda: spline([START, MEET, END]),
    "traced path of 60 rows": lambda: SampledPath(1.0, ROWS),
    "zone on a line": lambda: leave(FIRST.positions, 1.0, 0.2, 0.5),
}


@pytest.mark.parametrize("kind", MAKERS)
def test_making_a_path(kind: str, benchmark: Any) -> None:
    _, time = Measure(benchmark)(MAKERS[kind], rounds=500, warmup=20)
    benchmark.extra_info["us"] = 1e6 * time.median
    print(f"\n    us for a {kind}: {1e6 * time.median:.1f}", end="")


@pytest.mark.parametrize("kind", ["line", "arc", "corner", "spline of three points"])
def test_fifty_places_of_a_path_of_the_tool(kind: str, benchmark: Any) -> None:
    path = MAKERS[kind]()
    assert isinstance(path, Line | Arc | Curve)
    s = np.linspace(0.0, path.length, PLACES)
    measure = Measure(benchmark)
    _, time = measure(lambda: path.tool(s), rounds=500, warmup=20)
    measure.figure(f"us for {PLACES} places", 1e6 * time.median)


def test_fifty_places_of_a_traced_path(benchmark: Any) -> None:
    s = np.linspace(0.0, 1.0, PLACES)
    measure = Measure(benchmark)
    _, time = measure(lambda: TRACED.joints(s), rounds=500, warmup=20)
    measure.figure(f"us for {PLACES} places", 1e6 * time.median)


def test_a_spline_beside_those_of_scipy(benchmark: Any) -> None:
    """Those of scipy go over chords, without a way: neither arc length nor its derivatives."""
    measure = Measure(benchmark)
    way = np.arange(100) * 0.3
    p = np.stack((way, np.sin(way), np.cos(0.7 * way)), axis=1)
    turns = Rotation.from_rotvec(RNG.normal(size=(100, 3)) * 0.3)
    points = [Pose(at, np.roll(q, 1)) for at, q in zip(p, turns.as_quat(), strict=True)]
    knots = np.concatenate(([0.0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))))
    ours = spline(points)
    assert isinstance(ours, Curve)
    peers = CubicSpline(knots, p), RotationSpline(knots, turns)
    s, t = np.linspace(0.0, ours.length, 1000), np.linspace(0.0, knots[-1], 1000)

    def theirs() -> None:
        for order in range(3):
            peers[0](t, order)
            peers[1](t, order)

    making, made = processor_seconds(
        lambda: spline(points), lambda: (CubicSpline(knots, p), RotationSpline(knots, turns))
    )
    telling, told = processor_seconds(lambda: ours.tool(s), theirs)
    measure(lambda: ours.tool(s))
    measure.figure("making, times those of scipy", making / made, most=4.0)
    measure.figure("a thousand places, times those of scipy", telling / told, most=1.0)
