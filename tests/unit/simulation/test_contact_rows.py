"""Rows of a contact, its depth and its pass, against what ways in closed form say of them."""

from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from ropsim.flow import Contact, MotionKind, MoveEvent, Origin
from ropsim.model import Box, FixedObject, Part, Prism, Shape, Sphere, SupportLimits
from ropsim.simulation import run_collisions
from ropsim.spatial import Array, Pose
from support.box_depths import overlap
from support.carriages import RATE, SOURCE, crossed, led, turning

TOUCHING = 1e-4
"""Bodies that are no deeper in each other touch, see docs/explanation/collisions.md [m]."""
ROUGH = 5e-5
"""Depths are computed so finely [m]."""
EXACT = 1e-9
"""Rounding of poses and distances [m]."""
EDGE = 2.0**-4
"""Of cubes [m]; with it and other powers of 2 depths have no rounding."""
CUBE = Shape(Box((EDGE, EDGE, EDGE)))
PLACE = 1.0
"""Where a cube stands that is in the way, along x: carriages begin at 0 [m]."""
WALL = FixedObject("wall", Pose(np.array([PLACE, 0.0, 0.0])), (CUBE,))
PART = Part("part", np.full(3, EDGE), 1.0, Pose(np.array([PLACE, 0.0, EDGE / 2.0])))
X_ACROSS = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]])
X_ALONG = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]])
"""Rotations of the carriages, whose third axes are their ways."""
FAR = 4.0
"""There random ways begin, away from all that is in the way [m | rad]."""
SEEDS = 40
"""Number of random cases of each kind."""
Rows = list[tuple[int, int]]


def contacts(probe: tuple[Shape, ...], x: Array, **around: Any) -> tuple[Contact, ...]:
    """Return the contacts of a carriage that is led along x of the world [m]."""
    cell = crossed(probe, **around)
    return run_collisions(led(cell, {"across": x, "along": np.zeros(len(x))}), cell).facts.contacts


def deep(depth: Array, **around: Any) -> tuple[Contact, ...]:
    """Return the contacts of a cube that goes so deep into another one, row by row [m]."""
    return contacts((CUBE,), PLACE - EDGE + depth, **around)


def rows(found: tuple[Contact, ...]) -> Rows:
    return [(round(one.begin * RATE), round(one.end * RATE)) for one in found]


def runs(chosen: npt.NDArray[np.bool_]) -> Rows:
    """Return the first and last row of each run of rows that are chosen."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], chosen.astype(int), [0]])))
    return [(int(first), int(last) - 1) for first, last in edges.reshape(-1, 2)]


@pytest.mark.parametrize("clearance", [0.0, 0.01])
@pytest.mark.parametrize("supports", [0.0, 1e-4, 1e-3, 3e-3])
@pytest.mark.parametrize("kind", ["part", "object"])
def test_a_contact_lasts_while_bodies_are_deeper_than_they_may_be(
    kind: str, supports: float, clearance: float
) -> None:
    """What a part may be in others is the depth of supports, and a touch at least; all else may touch."""
    depth = np.concatenate([np.arange(-20.5, 42.0), np.arange(41.5, -21.0, -1.0)]) * 1e-4
    there = {"parts": (PART,)} if kind == "part" else {"objects": (WALL,)}
    found = deep(depth, supports=SupportLimits(depth=supports), clearance=clearance, **there)
    allowed = max(TOUCHING, supports) if kind == "part" else TOUCHING
    assert rows(found) == runs(depth > allowed)
    assert [-one.distance for one in found] == pytest.approx([depth.max()], abs=EXACT)


@pytest.mark.parametrize("clearance", [0.0, 0.01])
def test_bodies_that_are_exactly_as_deep_as_they_may_be_touch(clearance: float) -> None:
    limit = 2.0**-9
    depth = limit * np.array([-4.0, -1.0, 0.0, 1.0, 1.0, 1.5, 1.0, 1.0, 0.0, -4.0])
    around = {"supports": SupportLimits(depth=limit), "parts": (PART,), "clearance": clearance}
    assert rows(deep(depth, **around)) == [(5, 5)]
    assert deep(np.minimum(depth, limit), **around) == ()


@pytest.mark.parametrize("turn", [0.0, 0.2, 0.8])
def test_bodies_that_touch_for_long_collide_only_where_they_are_deeper(turn: float) -> None:
    """A ball in a turned box: the bound by boxes is far above its depth."""
    frame = np.array([np.cos(turn / 2.0), 0.0, np.sin(turn / 2.0), 0.0])
    ball = Shape(Sphere(0.05), Pose(np.zeros(3), frame))
    rest, dip = np.full(200, 8e-5), np.full(20, 3e-3)
    depth = np.concatenate([[-1.0], rest, dip, rest, dip + 1e-3, rest])
    found = contacts((ball,), PLACE - EDGE / 2.0 - 0.05 + depth, objects=(WALL,))
    assert rows(found) == runs(depth > TOUCHING) == [(201, 220), (421, 440)]
    assert [-one.distance for one in found] == pytest.approx([3e-3, 4e-3], abs=ROUGH)


@pytest.mark.parametrize("free", [1, 2, 3])
def test_each_row_at_which_bodies_are_apart_ends_a_contact(free: int) -> None:
    inside = np.array([0, 0, 1, 1, *[0] * free, 1, *[0] * free, 1, 1, 1, 0, 0], dtype=bool)
    assert rows(deep(np.where(inside, 2e-3, -2e-3), objects=(WALL,))) == runs(inside)


def test_a_contact_goes_on_from_one_convex_body_of_a_body_to_the_next() -> None:
    """A wall of two bricks with a joint between them, in which a narrow probe is free."""
    probe = (Shape(Box((0.02, 0.02, 0.02))),)
    bricks = tuple(Shape(Box((0.1, 0.1, 0.1)), Pose(np.array([x, 0.0, 0.0]))) for x in (0.92, 1.08))
    wall = FixedObject("wall", Pose(), bricks)
    over = np.array([-0.3, -0.1, -0.05, 0.05, 0.1, 0.3])  # from one brick into the other in one row
    through = np.array([-0.3, -0.1, -0.05, 0.0, 0.05, 0.1, 0.3])
    assert rows(contacts(probe, PLACE + over, objects=(wall,))) == [(1, 4)]
    assert rows(contacts(probe, PLACE + through, objects=(wall,))) == [(1, 2), (4, 5)]


def test_bodies_are_too_near_where_their_gap_is_no_more_than_the_clearance_and_they_do_not_collide() -> None:
    gap = np.array([90.0, 20.0, 10.0, 8.0, 3.0, 7.0, 20.0, 9.0, -4.0, -4.0, 2.0, 20.0, 0.0, 20.0]) * 1e-3
    cell = crossed((CUBE,), objects=(WALL,), clearance=0.009)
    way = {"across": PLACE - EDGE - gap, "along": np.zeros(len(gap))}
    facts = run_collisions(led(cell, way), cell).facts
    assert rows(facts.contacts) == [(8, 9)]
    assert rows(facts.near) == [(3, 5), (12, 12)]
    assert [one.distance for one in facts.near] == pytest.approx([3e-3, 0.0], abs=EXACT)


@pytest.mark.parametrize("clearance", [0.0, 0.01])
@pytest.mark.parametrize("other", ["along/link1", "bar"])
def test_bodies_in_each_other_from_the_first_to_the_last_row_are_drawn_so(
    clearance: float, other: str
) -> None:
    bar = Shape(Box((0.1, 0.1, 4.0)))  # along its way
    still = FixedObject("bar", Pose(), (Shape(Box((0.1, 4.0, 0.1))),))
    around = {"objects": (still,)} if other == "bar" else {}
    cell = crossed((bar,), () if other == "bar" else (bar,), clearance=clearance, **around)
    way = 0.3 * np.sin(np.linspace(0.0, 6.0, 50))
    facts = run_collisions(led(cell, {"across": way, "along": -way}), cell).facts
    assert (facts.contacts, facts.near) == ((), ())
    assert [{one.one, one.other} for one in facts.met] == [{"across/link1", other}]
    leaving = np.append(way, 5.0)
    facts = run_collisions(led(cell, {"across": leaving, "along": -leaving}), cell).facts
    assert rows(facts.contacts) == [(0, 49)]
    assert facts.met == ()
    coming = np.concatenate([[5.0], way])
    facts = run_collisions(led(cell, {"across": coming, "along": -coming}), cell).facts
    assert rows(facts.contacts) == [(1, 50)]


def balls(random: np.random.Generator) -> tuple[tuple[Array, float], ...]:
    """Return centre, shape (3,), and radius of three balls near to each other [m]."""
    return tuple((random.uniform(-0.2, 0.2, 3), float(random.uniform(0.05, 0.2))) for _ in range(3))


def shapes(some: tuple[tuple[Array, float], ...]) -> tuple[Shape, ...]:
    return tuple(Shape(Sphere(radius), Pose(centre)) for centre, radius in some)


def to_and_fro(random: np.random.Generator, count: int) -> Array:
    """Return a way that goes to and fro around 0 and begins far away [m], shape (count,)."""
    phase = np.linspace(0.0, 2.0 * np.pi, count)
    way = sum(random.normal() * np.sin(k * phase + random.uniform(0.0, 6.0)) / k for k in range(1, 6))
    return np.concatenate([[FAR], PLACE + 0.3 * np.asarray(way)])


Depths = Callable[[Array], Array]
"""Returns the depth at coordinates by rows [m], shape (k,)."""


def assert_contacts(found: tuple[Contact, ...], way: Array, depths: Depths) -> None:
    """Make sure that contacts are where bodies are deeper than a touch, with the greatest depth of rows.

    Depths are computed to `ROUGH`. Between two rows coordinates change evenly; contacts there are found, too.

    Args:
        found: the contacts.
        way: coordinates by rows, shape (k, n).
        depths: in closed form.
    """
    depth = depths(way)
    covered, between = np.zeros(len(depth), dtype=bool), set[int]()
    for one in found:
        first, last = int(np.ceil(one.begin * RATE - EXACT)), int(np.floor(one.end * RATE + EXACT))
        is_whole = abs(first - one.begin * RATE) < EXACT and abs(last - one.end * RATE) < EXACT
        covered[first : last + 1] = True
        most = float(depth[first : last + 1].max(initial=-np.inf))
        assert not is_whole or most > TOUCHING
        assert -one.distance == pytest.approx(most, abs=ROUGH) if is_whole else -one.distance > most - ROUGH
        if is_whole:
            assert depth[round(one.time * RATE)] == pytest.approx(most, abs=2.0 * ROUGH)
        else:
            between |= {int(one.begin * RATE), int(one.end * RATE)}
    assert (covered >= (depth > TOUCHING + ROUGH)).all()
    assert (covered <= (depth > TOUCHING - ROUGH)).all()
    for k in np.flatnonzero(~covered[:-1] & ~covered[1:]).tolist():
        most = float(depths(way[k] + np.linspace(0.0, 1.0, 200)[:, np.newaxis] * (way[k + 1] - way[k])).max())
        assert most < TOUCHING + ROUGH or k in between


@pytest.mark.parametrize("seed", range(SEEDS))
def test_the_depth_of_a_contact_is_the_greatest_of_its_rows_between_balls_on_any_ways(seed: int) -> None:
    random = np.random.default_rng(seed)
    probe, obstacle = balls(random), balls(random)
    x, y = to_and_fro(random, 400), to_and_fro(random, 400)
    cell = crossed(shapes(probe), shapes(obstacle))

    def depths(way: Array) -> Array:
        apart = np.outer(way[:, 0], X_ACROSS[:, 2]) - np.outer(way[:, 1], X_ALONG[:, 2])
        pairs = [
            r + s - np.linalg.norm(apart + X_ACROSS @ c - X_ALONG @ d, axis=1)
            for (c, r), (d, s) in product(probe, obstacle)
        ]
        return np.asarray(np.max(pairs, axis=0))

    found = run_collisions(led(cell, {"across": x, "along": y}), cell).facts.contacts
    assert_contacts(found, np.column_stack([x, y]), depths)


@pytest.mark.parametrize("seed", range(SEEDS))
def test_the_depth_of_a_contact_is_the_greatest_of_its_rows_where_a_rod_turns_past_balls(seed: int) -> None:
    random = np.random.default_rng(seed)
    halves = np.array([0.5, *random.uniform(0.01, 0.1, 2)])
    middle = np.array([random.uniform(0.45, 0.8), random.uniform(-0.1, 0.1), 0.0])
    turns = to_and_fro(random, 400)
    where = np.column_stack([random.uniform(0.2, 0.9, 2), random.uniform(0.2, 1.8, 2)])
    posts = tuple((np.array([r * np.cos(a), r * np.sin(a), 0.0]), 0.08) for r, a in where)
    rod = Shape(Box((float(2.0 * halves[0]), float(2.0 * halves[1]), float(2.0 * halves[2]))), Pose(middle))
    cell = turning((rod,), objects=(FixedObject("posts", Pose(), shapes(posts)),))
    found = run_collisions(led(cell, {"table": turns}), cell).facts.contacts

    def depths(way: Array) -> Array:
        c, s = np.cos(way[:, 0]), np.sin(way[:, 0])
        pairs = []
        for (x, y, _), radius in posts:
            beyond = np.abs(np.column_stack([c * x + s * y, c * y - s * x, 0.0 * c]) - middle) - halves
            outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
            pairs.append(radius - outside - np.minimum(beyond.max(axis=1), 0.0))
        return np.asarray(np.max(pairs, axis=0))

    assert_contacts(found, turns[:, np.newaxis], depths)


@pytest.mark.parametrize("seed", range(SEEDS))
def test_the_depth_of_a_contact_is_the_greatest_of_its_rows_between_boxes_that_turn(seed: int) -> None:
    random = np.random.default_rng(seed)
    sizes = random.uniform(0.02, 0.4, (2, 3))
    pose, post = (
        Pose(random.uniform(0.5, 0.7) * np.array([np.cos(a), np.sin(a), 0.0]), random.normal(size=4))
        for a in (0.0, random.uniform(0.6, 1.4))
    )
    turns = to_and_fro(random, 400)
    (x, y, z), edges = sizes.tolist()
    prism = Shape(Prism(((0.0, 0.0), (x, 0.0), (x, y), (0.0, y)), z), pose)
    cell = turning((prism,), objects=(FixedObject("post", post, (Shape(Box(tuple(edges))),)),))
    found = run_collisions(led(cell, {"table": turns}), cell).facts.contacts

    def depths(way: Array) -> Array:
        R = np.zeros((len(way), 3, 3))
        R[:, 0, 0] = R[:, 1, 1] = np.cos(way[:, 0])
        R[:, 1, 0], R[:, 2, 2] = np.sin(way[:, 0]), 1.0
        R[:, 0, 1] = -R[:, 1, 0]
        standing = np.tile(post.rotation(), (len(way), 1, 1)), np.tile(post.position, (len(way), 1))
        moving = R @ pose.rotation(), R @ (pose.position + pose.rotation() @ sizes[0] / 2.0)
        return overlap((*moving, sizes[0] / 2.0), (*standing, sizes[1] / 2.0))

    assert_contacts(found, turns[:, np.newaxis], depths)


def test_a_depth_that_grows_as_fast_as_bodies_move_is_found() -> None:
    """A ball goes straight through the slope of a wedge, in the middle of the box around that.

    Boxes say that it is the deepest at the slope. A beam beside it, in which a cube is almost as deep all the
    time, is no reason to leave the rows behind the slope out.
    """
    radius, beyond, almost = 0.05, 0.12, 0.166
    wedge = Shape(
        Prism(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), 1.0),
        Pose(np.array([PLACE + np.sqrt(0.5), 0.0, -0.5]), about_z(0.75 * np.pi)),
    )
    beam = Shape(Box((1.0, 1.0, 1.0)), Pose(np.array([PLACE + 0.2, 5.0, 0.0])))
    ball = Shape(Sphere(radius))
    cube = Shape(Box((0.4, 0.4, 0.4)), Pose(np.array([0.0, 5.0 - 0.7 + almost, 0.0])))
    there = np.concatenate([np.linspace(0.0, beyond, 20), np.linspace(beyond, 0.0, 20)])
    x = np.concatenate([[0.0], PLACE + there, [0.0]])
    (one,) = contacts((ball, cube), x, objects=(FixedObject("wedge", Pose(), (wedge, beam)),))
    assert -one.distance == pytest.approx(radius + beyond, abs=ROUGH)
    assert x[round(one.time * RATE)] == pytest.approx(PLACE + beyond)


def about_z(angle: float) -> Array:
    return np.array([np.cos(angle / 2.0), 0.0, 0.0, np.sin(angle / 2.0)])


def passes(
    begins: list[float], inside: npt.NDArray[np.bool_], changes: tuple[list[float], list[int]]
) -> list[tuple[int, int]]:
    """Return line and pass of each contact of a run on line 1 whose passes begin at times [s]."""
    depth = np.where(inside, 2e-3, -2e-3)
    cell = crossed((CUBE,), objects=(WALL,))
    moves = tuple(
        MoveEvent(
            time, 0.02, "across", Origin(SOURCE.span(1, 1, 3), number), motion=MotionKind.PTP, ordinal=number
        )
        for number, time in enumerate(begins, 1)
    )
    way = {"across": PLACE - EDGE + depth, "along": np.zeros(len(depth))}
    found = run_collisions(led(cell, way, lines=changes, events=moves), cell).facts.contacts
    return [(one.line, one.visit) for one in found]


@pytest.mark.parametrize(
    ("row", "number"), [(0, 1), (1, 1), (19, 1), (20, 1), (21, 2), (39, 2), (40, 2), (41, 3)]
)
def test_a_contact_is_of_the_pass_whose_control_period_its_first_row_ends(row: int, number: int) -> None:
    """A row holds what the time before it has led to: the row at which a pass begins is of the one before."""
    begins = [k / RATE for k in (0, 20, 40)]
    inside = np.arange(60) >= row
    assert passes(begins, inside, ([0.0], [1])) == [(1, number)]


def test_line_and_pass_of_a_contact_change_at_the_same_row() -> None:
    """Where the line is 1 again after another one, its pass is the next one."""
    begins = [k / RATE for k in (0, 20, 40)]
    changes = [k / RATE for k in (0, 10, 20, 30, 40)], [1, 2, 1, 2, 1]
    found = [passes(begins, np.arange(60) == row, changes) for row in range(1, 60)]
    expected = [(1, 1)] * 10 + [(2, 0)] * 10 + [(1, 2)] * 10 + [(2, 0)] * 10 + [(1, 3)] * 19
    assert found == [[one] for one in expected]
