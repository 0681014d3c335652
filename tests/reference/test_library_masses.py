"""Masses of library arms: mistakes of public descriptions of the same arms are not in them."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.model import RobotModel, audit
from ropsim.robotfile.testing import (
    arm_class_of,
    axis_loads,
    extended_length,
    joint_centres,
    total_mass,
)
from ropsim.spatial import Array

SERIAL = [
    name
    for name in robots.names()
    if not robots.load(name).couplings and robots.load(name).n >= 6 and name != "puma560"
]
"""Arms with a mass of each link: that of link 1 of the PUMA 560 is not published."""
PAYLOADS = {"panda": 3.0, "tx60": 3.5}
"""Where none is published [kg]."""


def masses(robot: RobotModel) -> list[float]:
    return [link.mass for link in robot.links]


def strayed(robot: RobotModel) -> Array:
    """Return distances of centres of mass from the lines of their links, over the longest, shape (n,)."""
    found = joint_centres(robot.joints, robot.X_nM)
    lines = np.diff(found.points, axis=0)
    longest = np.linalg.norm(lines, axis=1).max()
    away = []
    for link, X, begin, line in zip(robot.links, found.frames, found.points, lines, strict=False):
        centre = X[:3, :3] @ link.com + X[:3, 3] - begin
        share = np.clip(centre @ line / max(line @ line, 1e-12), 0.0, 1.0)
        away.append(float(np.linalg.norm(centre - share * line)) / longest)
    return np.array(away)


@pytest.mark.parametrize("name", SERIAL)
def test_centres_of_mass_are_by_their_links(name: str) -> None:
    assert strayed(robots.load(name)).max() < 0.5


def test_the_kr_210_has_its_centres_of_mass_in_its_own_frames() -> None:
    """Its file has those of the KR 120 in joint frames that were moved: 467 N·m at axis 3, not 1091."""
    robot = replace(robots.load("kr210_r2700_2"), drives=())
    assert axis_loads(robot, 0.0).greatest_gravity[2] == pytest.approx(1091.0, rel=0.02)
    links = list(robot.links)
    links[3] = replace(links[3], com=links[3].com + np.array([0.0, 0.0, 0.83]))
    assert axis_loads(replace(robot, links=tuple(links)), 0.0).greatest_gravity[2] < 800.0


def test_a_centre_beside_the_arm_stands_out() -> None:
    robot = robots.load("kr6_r900_2")
    links = list(robot.links)
    links[3] = replace(links[3], com=links[3].com + np.array([0.3, 0.0, 0.0]))
    assert int(np.argmax(strayed(replace(robot, links=tuple(links))))) == 3
    assert strayed(replace(robot, links=tuple(links))).max() > 0.5


@pytest.mark.parametrize("name", SERIAL)
def test_the_sum_of_masses_fits_payload_and_reach(name: str) -> None:
    """Files of the IRB 120 and the TX60 have 73 % and half of it, the last link of the TX60 12 g."""
    robot = robots.load(name)
    payload = PAYLOADS.get(name, robot.rated_payload)
    if not np.isfinite(payload):
        return
    usual = total_mass(arm_class_of(robot), payload, extended_length(robot.joints, robot.X_nM))
    heavy_of_old = 2.8 if name in ("irb140", "irb6640_180_255", "tx60") else 2.0
    assert usual / 2.0 < sum(masses(robot)) / 0.77 < heavy_of_old * usual
    assert masses(robot)[-1] > 2e-4 * sum(masses(robot))


def test_centres_of_the_stanford_arm_are_within_it() -> None:
    """A file in wide use has those of links 2 to 6 ten times too large, the boom at 6.447 m."""
    robot = robots.load("stanford")
    assert max(float(np.linalg.norm(link.com)) for link in robot.links) < 0.7
    assert masses(robot) == [9.29, 5.01, 4.25, 1.08, 0.63, 0.51]


@pytest.mark.parametrize("name", SERIAL)
def test_no_torque_limit_and_no_tensor_is_a_placeholder(name: str) -> None:
    """Efforts 1000 × 6 and 500 500 200 70 40 20, tensors of .001 on all diagonals stand in public files."""
    robot = robots.load(name)
    published = [one.kind != "estimated" for one in robot.origins if "torque" in one.parameters]
    assert published
    if name not in ("panda", "iiwa14", "ur3e", "ur5e", "ur10e"):  # modules: one torque for several axes
        assert len(set(np.round(robot.max_efforts, 6))) >= 3
    tensors = {tuple(link.inertia.ravel().tolist()) for link in robot.links}
    assert len(tensors) == len(robot.links)


@pytest.mark.parametrize("name", ["irb140", "irb660_180_315"])
def test_invented_masses_that_two_arms_share_are_in_none(name: str) -> None:
    """4rtur1t0/ARTE has [25 27 15 10 2.5 1.5] kg with tensors of the PUMA for both, and says so."""
    robot = robots.load(name)
    assert not {25.0, 27.0, 15.0, 10.0, 2.5, 1.5} & set(masses(robot))
    (origin,) = [one for one in robot.origins if one.parameters.startswith("masses")]
    assert origin.kind == "estimated"


@pytest.mark.parametrize(("name", "link"), [("panda", "4"), ("puma560", "3"), ("stanford", "5")])
def test_published_tensors_that_no_body_has_are_doubted_and_kept(name: str, link: str) -> None:
    found = [one for one in audit(robots.load(name)) if f"link `{link}` has the" in one.message]
    assert [one.code for one in found] == ["X854"] or [one.is_error for one in found] == [False]


def test_an_identified_set_is_whole_and_hides_the_friction_of_gears() -> None:
    """Two sets of the iiwa give 5.76 or 3.95 kg for link 1; both sensors are behind the gears."""
    robot = robots.load("iiwa14")
    assert masses(robot) == [5.76, 6.35, 3.5, 3.5, 3.5, 1.8, 1.2]
    kinds = {one.parameters.partition(" (")[0]: one.kind for one in robot.origins}
    assert kinds["masses, centres of mass, moments of inertia"] == "measured"
    assert kinds["friction"] == robots_friction("panda") == "estimated"


def robots_friction(name: str) -> str:
    (found,) = [one.kind for one in robots.load(name).origins if one.parameters.startswith("friction")]
    return found


@pytest.mark.parametrize(
    ("name", "whole"),
    [
        ("irb120", 25.0),
        ("irb1200_5_09", 54.1),
        ("kr6_r900_2", 55.16),
        ("panda", 16.18),
        ("lr_mate_200id", 25.0),
    ],
)
def test_the_base_is_not_among_the_moving_links(name: str, whole: float) -> None:
    assert 0.6 * whole < sum(masses(robots.load(name))) < 0.9 * whole
