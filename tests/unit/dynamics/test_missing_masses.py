"""Arms without masses: their torques are unknown, not zero, and no function ends in a bare error."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from ropsim import dynamics, robots
from ropsim.dynamics import MissingMassError, check_moved_masses, massless_axes
from ropsim.dynamics.mass_check import idle_axes
from ropsim.model import Drive, EffortAmplifier, Gear, IdealMotor, Link, Payload, RobotModel
from ropsim.spatial import Array
from support.examples import examples

FUNCTIONS: dict[str, Callable[[RobotModel, Array, Array], object]] = {
    "inverse_dynamics": lambda robot, q, rest: dynamics.inverse_dynamics(robot, q, rest, rest),
    "rigid_inverse_dynamics": lambda robot, q, rest: dynamics.rigid_inverse_dynamics(robot, q, rest, rest),
    "gravity": lambda robot, q, _: dynamics.gravity(robot, q),
    "bias": dynamics.bias,
    "forward_dynamics": lambda robot, q, rest: dynamics.forward_dynamics(robot, q, rest, rest),
    "mass_matrix": lambda robot, q, _: dynamics.mass_matrix(robot, q),
    "friction": dynamics.friction,
    "mass_matrices": lambda robot, q, _: dynamics.mass_matrices(robot, q[None]),
    "axis_inertias": lambda robot, q, _: dynamics.axis_inertias(robot, q[None]),
    "free_inertias": lambda robot, q, _: dynamics.free_inertias(robot, q[None]),
    "rotor_inertias": lambda robot, q, _: dynamics.rotor_inertias(robot, q[None]),
}
NEED_MASSES = (
    "inverse_dynamics",
    "rigid_inverse_dynamics",
    "gravity",
    "bias",
    "forward_dynamics",
    "mass_matrix",
    "mass_matrices",
    "axis_inertias",
    "free_inertias",
)
NOTHING = Link(0.0, np.zeros(3), np.zeros((3, 3)))


def without_masses(name: str) -> RobotModel:
    """Return an arm of the library of which nothing but the axes is known."""
    robot = robots.load(name)
    links = tuple(replace(NOTHING, shapes=link.shapes) for link in robot.links)
    return replace(robot, links=links, drives=())


def test_every_arm_of_the_library_has_masses_and_drives() -> None:
    for name in robots.names():
        robot = robots.load(name)
        assert any(link.mass for link in robot.links), name
        assert len(robot.drives) == robot.n, name


@pytest.mark.parametrize("name", robots.names())
def test_every_function_on_every_arm_of_the_library_gives_numbers(name: str) -> None:
    robot = robots.load(name)
    for function, call in FUNCTIONS.items():
        found = call(robot, np.array(robot.home), np.zeros(robot.n))
        assert np.isfinite(np.asarray(found, np.float64)).all(), function


@pytest.mark.parametrize("name", ["tx60", "panda", "irb660_180_315", "m10ia_12"])
def test_every_function_on_an_arm_without_masses_gives_numbers_or_says_what_is_missing(name: str) -> None:
    robot = without_masses(name)
    for function, call in FUNCTIONS.items():
        if function in NEED_MASSES:
            with pytest.raises(MissingMassError, match=f"`{name}`"):
                call(robot, np.array(robot.home), np.zeros(robot.n))
        else:
            found = call(robot, np.array(robot.home), np.zeros(robot.n))
            assert np.isfinite(np.asarray(found, np.float64)).all(), function


def test_the_error_of_an_arm_without_masses_says_so() -> None:
    robot = without_masses("tx60")
    with pytest.raises(MissingMassError) as caught:
        dynamics.forward_dynamics(robot, robot.home, np.zeros(6), np.zeros(6))
    assert caught.value.diagnostic.code == "M590"
    assert "no link of arm `tx60` has a mass" in caught.value.diagnostic.message


def test_an_axis_that_moves_no_inertia_is_named() -> None:
    puma = robots.load("puma560")
    bare = replace(puma, links=(*puma.links[:5], NOTHING), drives=())
    with pytest.raises(MissingMassError) as caught:
        dynamics.forward_dynamics(bare, bare.home, np.zeros(6), np.zeros(6))
    assert caught.value.diagnostic.code == "M591"
    assert "axis `6` of arm `puma560`" in caught.value.diagnostic.message


def test_a_mass_on_the_axis_gives_it_no_inertia_and_a_payload_beside_it_does() -> None:
    puma = robots.load("puma560")
    on_axis = Link(1.0, np.array([0.0, 0.0, 0.1]), np.zeros((3, 3)))
    bare = replace(puma, links=(*puma.links[:5], on_axis), drives=())
    with pytest.raises(MissingMassError):
        dynamics.forward_dynamics(bare, bare.home, np.zeros(6), np.zeros(6))
    beside = Payload(2.0, np.array([0.1, 0.0, 0.0]), np.zeros((3, 3)))
    found = dynamics.forward_dynamics(bare, bare.home, np.zeros(6), np.zeros(6), beside)
    assert np.isfinite(found).all()


def test_a_rotor_is_inertia_enough_for_an_axis() -> None:
    puma = robots.load("puma560")
    driven = replace(puma, links=(*puma.links[:5], NOTHING))
    assert np.isfinite(dynamics.forward_dynamics(driven, driven.home, np.zeros(6), np.zeros(6))).all()


@pytest.mark.parametrize("seed", range(examples(200)))
def test_an_axis_is_idle_where_it_adds_nothing_to_the_rank_of_those_behind_it_in_any_units(seed: int) -> None:
    """Mass matrices JᵀJ of small whole numbers, some of them singular, in units of any size for each axis."""
    random = np.random.default_rng(seed)
    n = int(random.integers(1, 7))
    J = random.integers(-2, 3, (n, n)) * random.integers(0, 2, (n, 1))
    ranks = [int(np.linalg.matrix_rank(J[:, k:])) for k in range(n)] + [0]
    expected = tuple(k for k in range(n) if ranks[k] == ranks[k + 1])
    units = 10.0 ** random.uniform(-9.0, 9.0, n)
    for M in (J.T @ J, units[:, None] * (J.T @ J) * units, 1e-140 * (J.T @ J), 1e140 * (J.T @ J)):
        assert idle_axes(M.astype(float)) == expected


def slides(first: float, second: float) -> Array:
    """Return the mass matrix of a slide that carries another one along its own way; masses in kg."""
    return np.array([[first + second, second], [second, second]])


def test_a_milligram_under_a_tonne_is_a_mass_and_what_rounding_leaves_of_one_is_none() -> None:
    assert idle_axes(slides(1e-6, 1e3)) == ()
    assert idle_axes(slides(1e-11, 1e3)) == (0,)
    assert idle_axes(slides(1e3, 1e-6)) == ()
    assert idle_axes(slides(1e3, 0.0)) == (1,)
    assert idle_axes(np.zeros((2, 2))) == (0, 1)
    assert idle_axes(np.diag([1.0, -1e-3])) == (1,)


@pytest.mark.parametrize("massless", [(0, 1, 2, 3, 4, 5), (5, 6)])
def test_drives_need_links_with_masses_to_move(massless: tuple[int, ...]) -> None:
    """One body of a seven-axis arm has six freedoms to be moved in; the last links alone move nothing."""
    robot = direct("panda")
    links = tuple(NOTHING if k in massless else link for k, link in enumerate(robot.links))
    with pytest.raises(MissingMassError) as caught:
        check_moved_masses(replace(robot, links=links))
    found = caught.value.diagnostic
    assert found.code == "M591"
    assert all(f"`{robot.joints[k].name}`" in found.message for k in massless)
    assert "ropsim robot estimate" in found.hint


def test_a_link_without_mass_between_others_may_be() -> None:
    robot = direct("ur5e")
    links = tuple(NOTHING if k == 3 else link for k, link in enumerate(robot.links))
    assert massless_axes(replace(robot, links=links)) == (3,)
    check_moved_masses(replace(robot, links=links))


def direct(name: str) -> RobotModel:
    """Return an arm of the library with drives that have no rotors."""
    robot = robots.load(name)
    drives = tuple(Drive(EffortAmplifier(50.0), IdealMotor(0.0), Gear(1.0)) for _ in robot.drives)
    return replace(robot, drives=drives)
