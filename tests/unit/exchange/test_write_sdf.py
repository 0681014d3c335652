"""SDFormat out: a reader of a few lines finds the same poses and weights in it."""

from xml.etree import ElementTree as ET

import numpy as np
import pytest

from ropsim import robots
from ropsim.exchange import write_sdf
from ropsim.kinematics import forward
from ropsim.model import RobotModel
from ropsim.spatial import Array
from support.built_in import WRITTEN
from support.exchange_laws import random_chain

SAME = 1e-12


def part(element: ET.Element, path: str) -> ET.Element:
    found = element.find(path)
    assert found is not None, path
    return found


def figures(element: ET.Element | None, count: int = 1) -> list[float]:
    return [float(word) for word in (element.text or "").split()] if element is not None else [0.0] * count


def matrix(row: list[float]) -> Array:
    (sr, sp, sy), (cr, cp, cy) = np.sin(row[3:]), np.cos(row[3:])
    X = np.eye(4)
    X[:3, :3] = [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
    X[:3, 3] = row[:3]
    return X


def flange(text: str, robot: RobotModel, q: Array) -> Array:
    """Return the pose of the interface, as links, joints and mimics of the text say."""
    model = part(ET.fromstring(text), "model")
    axes: dict[str, float] = {
        joint.name: float(value) for joint, value in zip(robot.axis_joints, q, strict=True)
    }
    joints = {part(one, "child").text: one for one in model.iter("joint") if one.find("child") is not None}

    def coordinate(joint: ET.Element) -> float:
        mimic = joint.find("axis/mimic")
        if mimic is None:
            return axes.get(joint.get("name", ""), 0.0)
        factor, offset = figures(part(mimic, "multiplier"), 1)[0], figures(part(mimic, "offset"), 1)[0]
        return factor * axes[mimic.get("joint", "")] + offset

    def link(name: str) -> Array:
        if name == "base_link":
            return np.eye(4)
        pose = part(next(one for one in model.iter("link") if one.get("name") == name), "pose")
        joint = joints[name]
        assert pose.get("relative_to") == part(joint, "parent").text
        value, kind = coordinate(joint), joint.get("type")
        moved = matrix([0.0, 0.0, value if kind == "prismatic" else 0.0, 0.0, 0.0, 0.0])
        turned = matrix([0.0, 0.0, 0.0, 0.0, 0.0, value if kind == "revolute" else 0.0])
        return np.asarray(link(pose.get("relative_to", "")) @ matrix(figures(pose, 6)) @ moved @ turned)

    frame = part(model, "frame")
    return np.asarray(link(frame.get("attached_to", "")) @ matrix(figures(frame.find("pose"), 6)))


CASES = [*map(robots.load, WRITTEN), *map(random_chain, range(3))]


@pytest.mark.parametrize("robot", CASES, ids=lambda one: one.name)
def test_the_flange_is_where_it_is(robot: RobotModel) -> None:
    text = write_sdf(robot).text
    for q in np.random.default_rng(4).uniform(-1.5, 1.5, (3, robot.n)):
        np.testing.assert_allclose(flange(text, robot, q), forward(robot, q).matrix(), atol=SAME)


def test_links_have_their_weights_and_none_is_left_to_the_default() -> None:
    robot = robots.load("puma560")
    links = {one.get("name"): one for one in ET.fromstring(write_sdf(robot).text).iter("link")}
    for joint, link in zip(robot.joints, robot.links, strict=True):
        inertial = part(links[f"link_{joint.name}"], "inertial")
        assert float(part(inertial, "mass").text or "") == max(link.mass, 1e-12)
        assert figures(inertial.find("pose"), 6)[:3] == link.com.tolist()
        ixx, iyy, izz = (float(part(inertial, f"inertia/i{k}{k}").text or "") for k in "xyz")
        a, b, c = sorted((ixx, iyy, izz))
        assert a + b >= c > 0.0


def test_losses_name_what_is_dropped() -> None:
    words = " ".join(one.message for one in write_sdf(robots.load("puma560")).losses)
    for what in ("accelerations and jerks", "rotors of axes `1`", "motor constants", "home position"):
        assert what in words
