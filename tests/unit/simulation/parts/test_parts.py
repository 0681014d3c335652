import numpy as np
import pytest

from ropsim import robots
from ropsim.kinematics import NO_BLOCKS
from ropsim.model import WORLD, Cell, Gripper, Part, Sink, Tool
from ropsim.simulation.testing import Moment, Placements, close_on, initial_parts, payload, release
from ropsim.spatial import Pose, fingerprint
from support.cells import one_station

JAWS = Tool("jaws", Pose(np.array([0.0, 0.0, 0.1])), 1.0, gripper=Gripper(0.2, 0.2, 0.005))
HAND = "tool:jaws"
DOWN = np.array([0.0, 1.0, 0.0, 0.0])


def part(name: str, x: float, supply: str = "", turn: int = 0) -> Part:
    return Part(name, np.array([0.06, 0.06, 0.04]), 0.5, Pose(np.array([x, 0.0, 0.04])), supply, turn)


def cell(*parts: Part) -> Cell:
    robot = robots.load("puma560")
    return one_station(
        "c",
        robot,
        robots.default_controller("puma560"),
        tools={"jaws": JAWS},
        parts=parts,
        sinks=(Sink("bin", (0.9, 0.0, 0.04), 0.02),),
    )


def at(x: float) -> Moment:
    """Mechanical interface above x, tool pointing down, TCP at the height of the grasp points."""
    return Moment({HAND: Pose(np.array([x, 0.0, 0.14]), DOWN)}, NO_BLOCKS)


def closed(scene: Cell, x: float, state: Placements | None = None) -> Placements:
    return close_on(state or initial_parts(scene), scene, JAWS, HAND, at(x))


def resting(state: Placements) -> set[str]:
    return {name for name, seat in state.seats.items() if seat.rides == WORLD}


def test_closing_takes_the_nearest_part_within_the_capture() -> None:
    scene = cell(part("a", 0.500), part("b", 0.501))
    state = closed(scene, 0.5007)
    assert state.held({HAND}) == "b"
    assert resting(state) == {"a"}


def test_closing_beside_a_part_takes_nothing() -> None:
    scene = cell(part("a", 0.5))
    assert closed(scene, 0.506).held({HAND}) == ""


def test_a_grasped_part_adds_its_mass_at_its_centre() -> None:
    scene = cell(part("a", 0.5))
    state = closed(scene, 0.5)
    load = payload(state.carried({HAND}), {"a": scene.parts[0]}, JAWS)
    assert load.mass == 1.5
    # tool mass at the interface, part centre 20 mm beyond the TCP at 100 mm
    np.testing.assert_allclose(load.com, [0.0, 0.0, 0.5 * 0.12 / 1.5], atol=1e-12)


TURNS = [
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 1.0, 0.0, 0.0),
    (0.0, 0.0, -1.0, 0.0),
    (0.0, 0.0, 0.0, 1.0),
    (0.0, 0.6, -0.8, 0.0),
    (0.0, -0.6, 0.0, -0.8),
    (0.0, 0.48, -0.6, 0.64),
    (0.6, 0.0, -0.8, 0.0),
    (0.5, -0.5, 0.5, 0.5),
]


@pytest.mark.parametrize("turn", TURNS)
def test_a_part_is_the_same_body_however_the_arm_came_to_where_it_was_taken(
    turn: tuple[float, float, float, float],
) -> None:
    """Attained poses differ in their last digits; quaternions of half turns in their sign, too."""
    random, scene = np.random.default_rng(3), cell(part("a", 0.5))
    place = np.array([0.0123, 0.0, 0.15])
    loads = [
        payload(
            {"a": Pose(place + random.normal(0.0, 1e-8, 3), np.array(turn) + random.normal(0.0, 1e-8, 4))},
            {"a": scene.parts[0]},
            JAWS,
        )
        for _ in range(20)
    ]
    assert len({fingerprint(one) for one in loads}) == 1
    exact = payload({"a": Pose(place, np.array(turn))}, {"a": scene.parts[0]}, None)
    centre = place + Pose(place, np.array(turn)).rotation() @ [0.0, 0.0, -scene.parts[0].size[2] / 2.0]
    np.testing.assert_allclose(exact.com, centre, atol=1e-6)


def test_a_supply_shows_the_next_part_when_one_is_taken() -> None:
    scene = cell(part("a", 0.5, "infeed", 0), part("b", 0.5, "infeed", 1), part("c", 0.5, "infeed", 2))
    state = initial_parts(scene)
    assert resting(state) == {"a"}
    state = closed(scene, 0.5, state)
    assert resting(state) == {"b"}
    assert state.queued == {"c"}


def test_a_released_part_stays_where_it_was_put() -> None:
    scene = cell(part("a", 0.5))
    state = release(closed(scene, 0.5), scene, {HAND}, at(0.7))
    assert state.held({HAND}) == ""
    np.testing.assert_allclose(state.seats["a"].pose.position, [0.7, 0.0, 0.04], atol=1e-12)


def test_a_part_released_at_a_sink_leaves() -> None:
    scene = cell(part("a", 0.5))
    state = release(closed(scene, 0.5), scene, {HAND}, at(0.9))
    assert tuple(state.left) == ("a",)
    assert not state.seats


@pytest.mark.parametrize(("beside", "left"), [(0.019, ("a",)), (0.021, ())])
def test_a_sink_takes_what_is_released_within_its_radius(beside: float, left: tuple[str, ...]) -> None:
    scene = cell(part("a", 0.5))
    state = release(closed(scene, 0.5), scene, {HAND}, at(0.9 + beside))
    assert tuple(state.left) == left
