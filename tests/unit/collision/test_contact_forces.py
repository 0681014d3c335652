"""Forces of bodies that are pressed on others: stiffness, continuity, energy, friction, and other engines."""

import math
from itertools import pairwise

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from ropsim.collision import ContactLaw, ContactPairs, TouchingPair, convexes
from ropsim.model import FLOOR, Box, Cylinder, Prism, Shape, Solid, Sphere, capsule
from ropsim.spatial import Array

STIFFNESS = 1e5
SPRING = ContactLaw(STIFFNESS, 0.0, 0.0)
DEPTH = 1e-4
PLATE = Box((1.0, 1.0, 0.1))
"""Its middle is at the origin of the world, its top at z = 50 mm."""
TOP = 0.05
FACES = (
    Box((0.02, 0.03, 0.04)),
    Cylinder(0.01, 0.04),
    Prism(((0, 0), (0.02, 0), (0.02, 0.02), (0, 0.02)), 0.04),
)


def at(x: float, y: float, z: float, turn: Array | None = None) -> Array:
    """Return a pose, turned by a vector [rad]."""
    pose = np.eye(4)
    pose[:3, 3] = x, y, z
    if turn is not None:
        pose[:3, :3] = Rotation.from_rotvec(turn).as_matrix()
    return pose


def pair(solid: Solid, law: ContactLaw = SPRING, on: Solid = PLATE) -> ContactPairs:
    """Return a solid that is pressed on another one."""
    solids = {"a": convexes(Shape(solid)), "b": convexes(Shape(on))}
    return ContactPairs(solids, [TouchingPair("a", "b", law)])


def wrench(pairs: ContactPairs, pose: Array, velocity: Array | None = None) -> Array:
    """Return force and moment about the origin of the solid that moves."""
    motion = np.zeros((3, 3))
    motion[0] = pose[:3, 3]
    if velocity is not None:
        motion[1:] = velocity
    return pairs.pressed(pairs.placed({"a": pose, "b": np.eye(4)}), motion).wrench


@pytest.mark.parametrize("solid", [*FACES, Sphere(0.02)])
def test_a_face_that_rests_as_a_whole_and_a_ball_have_the_stated_stiffness(solid: Solid) -> None:
    low = 0.0 if isinstance(solid, Prism) else 0.02
    found = wrench(pair(solid), at(0.1, 0.2, TOP + low - DEPTH))
    assert found[:3] == pytest.approx([0.0, 0.0, STIFFNESS * DEPTH], rel=1e-6, abs=1e-9)


def test_the_floor_pushes_back_as_a_plate_does() -> None:
    pairs = ContactPairs({"a": convexes(Shape(FACES[0]))}, [TouchingPair("a", FLOOR, SPRING)], FLOOR)
    pose = at(3.0, -2.0, 0.02 - DEPTH)
    found = pairs.pressed(pairs.placed({"a": pose}), np.zeros((3, 3))).wrench
    assert found[:3] == pytest.approx([0.0, 0.0, STIFFNESS * DEPTH], rel=1e-9)
    assert found[3:] == pytest.approx(np.cross(pose[:3, 3], found[:3]), abs=1e-9)


@pytest.mark.parametrize(
    ("turn", "share"),
    [((0.3, 0.0, 0.0), 0.75), ((0.3, 0.4, 0.0), 0.6)],
    ids=["edge", "corner"],
)
def test_edges_and_corners_are_softer_as_the_manual_says(turn: tuple[float, ...], share: float) -> None:
    corners = np.array([(x, y, z) for x in (-0.01, 0.01) for y in (-0.015, 0.015) for z in (-0.02, 0.02)])
    low = -(corners @ Rotation.from_rotvec(turn).as_matrix().T)[:, 2].min()
    found = wrench(pair(FACES[0]), at(0.1, 0.2, TOP + low - DEPTH, np.array(turn)))
    assert found[2] == pytest.approx(share * STIFFNESS * DEPTH, rel=0.02)


@pytest.mark.parametrize(
    ("solid", "pose", "on", "least", "most"),
    [
        (FACES[1], at(0.1, 0.2, TOP + 0.01 - DEPTH, np.array([math.pi / 2.0, 0.0, 0.0])), PLATE, 0.3, 0.6),
        (capsule(0.01, 0.05), at(0.1, 0.2, TOP + 0.035 - DEPTH), PLATE, 0.3, 0.6),
        (Box((0.2, 0.2, 0.02)), at(0.0, 0.0, 0.06 - DEPTH), Box((0.05, 0.05, 0.1)), 1.35, 1.4),
        (Box((0.05, 0.05, 0.02)), at(0.0, 0.0, 0.06 - DEPTH), Box((0.05, 0.05, 0.1)), 0.7, 0.72),
    ],
    ids=["side", "round end", "cover", "same"],
)
def test_other_touches_have_stiffnesses_within_what_the_manual_says(
    solid: Solid, pose: Array, on: Solid, least: float, most: float
) -> None:
    found = wrench(pair(solid, SPRING, on), pose)[2] / (STIFFNESS * DEPTH)
    assert least < found < most


def _ways(seed: int, count: int) -> list[Array]:
    """Return poses of a box on a closed way over the edge of the plate, in and out of it."""
    rng = np.random.default_rng(seed)
    sizes = np.array([3e-4, 3e-4, 1e-4, 5e-3, 5e-3, 5e-3])
    one, other = rng.normal(size=6) * sizes, rng.normal(size=6) * sizes
    angles = np.linspace(0.0, 2.0 * math.pi, count + 1)
    shifts = np.cos(angles)[:, None] * one + np.sin(angles)[:, None] * other
    return [at(0.495 + s[0], 0.1 + s[1], TOP + 0.02 - DEPTH + s[2], s[3:]) for s in shifts]


@pytest.mark.parametrize("seed", range(4))
def test_springs_do_no_work_on_a_closed_way(seed: int) -> None:
    """Also none over the edge of the plate, where the nearest plane changes."""
    pairs = pair(FACES[0])
    done = total = 0.0
    poses = _ways(seed, 800)
    wrenches = [wrench(pairs, pose) for pose in poses]
    for (X, Y), (one, other) in zip(pairwise(poses), pairwise(wrenches), strict=True):
        shift = Y[:3, 3] - X[:3, 3]
        turn = Rotation.from_matrix(Y[:3, :3] @ X[:3, :3].T).as_rotvec()
        work = 0.5 * float((one + other) @ np.concatenate((shift, turn)))
        done, total = done + work, total + abs(work)
    assert total > 1e-4  # [J]
    assert abs(done) < 1e-7 * total


@pytest.mark.parametrize("solid", [FACES[0], FACES[1], Sphere(0.02)])
def test_the_force_has_no_jump(solid: Solid) -> None:
    """Half a step changes it half as much, on a way across the edge of the plate."""
    pairs = pair(solid, ContactLaw(STIFFNESS, 500.0, 0.3))
    velocity = np.array([[0.02, 0.01, -0.03], [0.1, 0.2, 0.0]])

    def jumps(count: int) -> float:
        shifts = np.linspace(-5e-4, 5e-4, count)
        way = [
            at(0.5 + 5.0 * s, 0.1, TOP + 0.02 - DEPTH + 0.5 * s, np.array([8 * s, 5 * s, 0.0]))
            for s in shifts
        ]
        forces = np.array([wrench(pairs, pose, velocity) for pose in way])
        return float(np.abs(np.diff(forces, axis=0)[:, :3]).max())

    coarse, fine = jumps(401), jumps(1601)
    assert coarse > 1e-3
    assert fine < 0.4 * coarse


def test_what_parts_is_not_held_back() -> None:
    pairs = pair(FACES[0], ContactLaw(STIFFNESS, 1e4, 0.2))
    leaving = np.array([[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]])
    assert not wrench(pairs, at(0.1, 0.2, TOP + 0.02 - DEPTH), leaving).any()


@pytest.mark.parametrize("solid", [FACES[0], FACES[1], Sphere(0.02)])
def test_sliding_friction_is_mu_times_the_normal_force_against_the_motion(solid: Solid) -> None:
    pairs = pair(solid, ContactLaw(STIFFNESS, 1e4, 0.3))
    sliding = np.array([[0.03, 0.04, 0.0], [0.0, 0.0, 0.0]])
    found = wrench(pairs, at(0.1, 0.2, TOP + 0.02 - DEPTH), sliding)
    normal = STIFFNESS * DEPTH
    assert found[:3] == pytest.approx([-0.18 * normal, -0.24 * normal, normal], rel=1e-6)


@pytest.mark.parametrize("solid", [FACES[0], FACES[1], Sphere(0.02)])
@pytest.mark.parametrize("damping", [1.0, 200.0, 1e4])
def test_friction_is_full_from_one_millimetre_per_second_on_whatever_the_damping(
    solid: Solid, damping: float
) -> None:
    pairs, pose = pair(solid, ContactLaw(STIFFNESS, damping, 0.3)), at(0.1, 0.2, TOP + 0.02 - DEPTH)
    for speed, share in ((0.5e-3, 0.5), (1e-3, 1.0), (5e-3, 1.0)):
        found = wrench(pairs, pose, np.array([[speed, 0.0, 0.0], [0.0, 0.0, 0.0]]))
        assert found[0] == pytest.approx(-0.3 * share * found[2], rel=1e-6)


@pytest.mark.parametrize("mass", [0.5, 3.0, 1e3])
def test_friction_stops_a_light_mass_within_a_tick_and_no_sooner(mass: float) -> None:
    pairs, pose = pair(Sphere(0.02), ContactLaw(STIFFNESS, 200.0, 0.3)), at(0.1, 0.2, TOP + 0.02 - DEPTH)
    period, speed, motion = 1e-3, 1e-3, np.zeros((3, 3))
    mobility = np.diag([period / mass] * 3 + [0.0] * 3)
    motion[0], motion[1, 0] = pose[:3, 3], speed
    found = pairs.pressed(pairs.placed({"a": pose, "b": np.eye(4)}), motion, mobility).wrench
    assert -found[0] == pytest.approx(min(0.3 * STIFFNESS * DEPTH, mass * speed / period), rel=1e-6)


@pytest.mark.parametrize("solid", FACES)
def test_friction_that_is_held_over_a_tick_takes_energy_from_what_it_slows_down(solid: Solid) -> None:
    """Of bodies with any masses, about any point, however they slide and turn: light ones are stopped."""
    random = np.random.default_rng(3)
    rough, smooth = (pair(solid, ContactLaw(STIFFNESS, 1.0, share)) for share in (5.0, 0.0))
    for _ in range(100):
        pose = at(0.1, 0.2, TOP + 0.02 - DEPTH, random.normal(size=3) * 1e-3)
        root = random.normal(size=(6, 6)) * 10.0 ** random.uniform(-2.0, 0.0)
        mobility, motion = root @ root.T, np.zeros((3, 3))
        motion[0], motion[1:] = pose[:3, 3] + random.normal(size=3) * 0.1, random.normal(size=(2, 3)) * 1e-2
        motion[1, 2] = 0.0
        placed = (one.placed({"a": pose, "b": np.eye(4)}) for one in (rough, smooth))
        drag, plain = (
            one.pressed(where, motion, mobility).wrench
            for one, where in zip((rough, smooth), placed, strict=True)
        )
        friction, velocity = drag - plain, motion[1:].ravel()
        change = friction @ velocity + 0.5 * friction @ mobility @ friction
        assert change <= 1e-12 * abs(friction @ velocity)
        assert friction @ velocity <= 0.0


def _hole(wide: float) -> dict[str, tuple[Solid, Array]]:
    """Return four boxes around a square hole along z."""
    half = 0.5 * wide + 0.02
    return {
        "east": (Box((0.04, 0.12, 0.03)), at(half, 0.0, 0.0)),
        "west": (Box((0.04, 0.12, 0.03)), at(-half, 0.0, 0.0)),
        "north": (Box((wide, 0.04, 0.03)), at(0.0, half, 0.0)),
        "south": (Box((wide, 0.04, 0.03)), at(0.0, -half, 0.0)),
    }


@pytest.mark.parametrize("peg", [Cylinder(0.01, 0.04), Box((0.02, 0.02, 0.04))])
def test_a_peg_in_a_tight_hole_touches_both_walls(peg: Solid) -> None:
    """It is wider than the hole by twice the depth: centred, the walls cancel; beside, they push it back."""
    walls = _hole(0.02 - 2.0 * DEPTH)
    solids = {"a": convexes(Shape(peg)), **{name: convexes(Shape(one)) for name, (one, _) in walls.items()}}
    pairs = ContactPairs(solids, [TouchingPair("a", name, SPRING) for name in walls])
    stand = {name: pose for name, (_, pose) in walls.items()}
    motion = np.zeros((3, 3))

    def force(x: float, tilt: float = 0.0) -> Array:
        pose = at(x, 0.0, 0.012, np.array([0.0, tilt, 0.0]))
        motion[0] = pose[:3, 3]
        return pairs.pressed(pairs.placed({"a": pose, **stand}), motion).wrench

    centred = force(0.0)
    assert np.abs(centred[:3]).max() < 1e-6
    alone = ContactPairs(solids, [TouchingPair("a", "east", SPRING)])
    one_wall = alone.pressed(alone.placed({"a": at(0.0, 0.0, 0.012), **stand}), motion).wrench
    assert -one_wall[0] > 0.3 * STIFFNESS * DEPTH
    assert force(0.5 * DEPTH)[0] < -0.3 * STIFFNESS * DEPTH
    assert force(-0.5 * DEPTH)[0] == pytest.approx(-force(0.5 * DEPTH)[0], rel=1e-6)
    assert force(0.0, 0.01)[4] < 0.0 < force(0.0, -0.01)[4]  # jammed, it is turned upright


BOUNCING = """
<mujoco><option timestep="1e-5" gravity="0 0 0" integrator="RK4"/>
<default><geom solref="-{k} -{b}" solimp="0.9999 0.9999 0.001" friction="0 0 0" condim="1"/></default>
<worldbody><geom type="plane" size="1 1 1"/>
<body pos="0 0 0.0205"><freejoint/><geom type="sphere" size="0.02" mass="2"/></body></worldbody></mujoco>
"""


def test_a_ball_bounces_off_a_plane_as_in_mujoco() -> None:
    """MuJoCo states stiffness and damping over the mass; without weight, which its rest depth contains."""
    mass, k, c = 2.0, 5e4, 120.0
    model = mujoco.MjModel.from_xml_string(BOUNCING.format(k=k / mass, b=c / mass))
    data = mujoco.MjData(model)
    data.qvel[2] = -0.2
    pairs = ContactPairs(
        {"a": convexes(Shape(Sphere(0.02)))}, [TouchingPair("a", FLOOR, ContactLaw(k, c, 0.0))], FLOOR
    )
    z, speed, step = 0.0205, -0.2, 1e-5
    lowest = [z, z]
    for _ in range(3000):
        mujoco.mj_step(model, data)
        motion = np.array([[0.0, 0.0, z], [0.0, 0.0, speed], [0.0, 0.0, 0.0]])
        pose = at(0.0, 0.0, z + 0.5 * step * speed)
        force = pairs.pressed(pairs.placed({"a": pose}), motion).wrench[2]
        z, speed = z + step * speed + 0.5 * step * step * force / mass, speed + step * force / mass
        lowest = [min(lowest[0], z), min(lowest[1], float(data.qpos[2]))]
    assert data.qvel[2] > 0.1
    assert 0.02 - lowest[0] == pytest.approx(0.02 - lowest[1], rel=0.01)
    assert speed == pytest.approx(float(data.qvel[2]), rel=0.01)
