"""Defaults and options of MJCF: what they give to elements is what MuJoCo makes of them."""

from functools import partial
from typing import Any

import numpy as np
import pytest

from ropsim.core import SourceText
from ropsim.exchange import read_mjcf
from ropsim.exchange.testing import MOST_ATTRIBUTES
from ropsim.model import ReadRobot
from support.mjcf_texts import ARM
from support.mujoco_files import MujocoFile
from support.work import calls_of, peak_of

SAME = 1e-12
"""Relative: both engines make the same few products."""
ONE = """<mujoco><default>{default}</default>{more}<worldbody><body>
<joint name="j" axis="0 1 0" range="-1 1" {joint}/>{geom}</body></worldbody></mujoco>"""


def read(text: str) -> ReadRobot:
    found = read_mjcf(SourceText("arm.xml", text))
    assert found.robot is not None, found.findings
    return found


def one(default: str, geom: str = '<geom size="0.1"/>', more: str = "", joint: str = "") -> str:
    return ONE.format(default=default, geom=geom, more=more, joint=joint)


@pytest.mark.parametrize(
    "option",
    [
        '<option><flag gravity="disable"/></option>',
        '<option gravity="0 0 -5"><flag gravity="disable"/></option>',
        '<option><flag gravity="disable"/></option><option gravity="0 1 -5"/>',
        '<option><flag gravity="disable"/></option><option gravity="0 0 -5"/>'
        '<option><flag gravity="enable"/></option>',
        '<option gravity="1 2 3"><flag contact="disable"/></option>',
    ],
)
def test_bodies_fall_as_the_flags_of_the_file_say(option: str) -> None:
    text = one("", more=option)
    model: Any = MujocoFile(text).model
    falls = not model.opt.disableflags & 1 << 7  # mjDSBL_GRAVITY
    robot = read(text).robot
    assert robot is not None
    assert robot.gravity.tolist() == (model.opt.gravity.tolist() if falls else [0.0, 0.0, 0.0])


def test_a_flag_that_neither_enables_nor_disables_is_refused() -> None:
    found = read_mjcf(SourceText("arm.xml", one("", more='<option><flag gravity="off"/></option>')))
    assert [one.code for one in found.findings if one.is_error] == ["X983"]


@pytest.mark.parametrize(
    ("default", "geom"),
    [
        ('<geom mass="7" type="capsule"/>', '<geom density="1000" size=".02 .1"/>'),
        ('<geom density="100"/>', '<geom mass="1" size=".02"/>'),
        ('<geom mass="7"/><default class="c"><geom density="9"/></default>', '<geom class="c" size=".1"/>'),
        ('<geom type="capsule" size=".05 .1"/>', '<geom size=".02"/>'),
        ('<geom type="box" size=".05 .1 .3"/>', '<geom size=".02 .04"/>'),
        ('<geom type="box" size=".05 .1 .3"/>', '<geom size=""/>'),
        (
            '<geom type="box" size=".5 .1 .3"/><default class="c"><geom size=".2 .4"/></default>',
            '<geom class="c" size=".1"/>',
        ),
        (
            '<default class="c"><geom size=".1"/></default><geom mass="5"/>',
            '<geom class="c"/>',
        ),
        (
            '<default class="c"><geom size=".1"/></default></default><default><geom mass="5"/>',
            '<geom class="c"/><geom size=".2"/>',
        ),
    ],
)
def test_geometry_has_the_weight_that_mujoco_gives_it(default: str, geom: str) -> None:
    robot = read(one(default, geom)).robot
    model: Any = MujocoFile(one(default, geom)).model
    assert robot is not None
    assert robot.links[0].mass == pytest.approx(model.body_mass[1], rel=SAME)
    moments = np.linalg.eigvalsh(robot.links[0].inertia)
    np.testing.assert_allclose(moments, np.sort(model.body_inertia[1]), rtol=1e-9)


def test_numbers_of_joints_and_actuators_lie_over_the_first_ones_of_their_defaults() -> None:
    text = one('<joint damping="1 2 3" stiffness="0 1"/><motor gear="2 3"/>', joint='damping="4"')
    text = text.replace(
        "</mujoco>",
        '<actuator><motor joint="j" forcerange="-1 1" gear="5"/></actuator></mujoco>',
    )
    found = read(text)
    model: Any = MujocoFile(text).model
    assert found.robot is not None
    assert found.robot.max_efforts.tolist() == [model.actuator_gear[0][0]]
    data = {key: names for finding in found.findings for key, names in finding.data.items()}
    assert data["damping that grows"] == ("j",)
    assert model.dof_dampingpoly[0].tolist() == [2.0, 3.0]
    assert data["springs"] == ("j",)
    assert model.jnt_stiffnesspoly[0].tolist() == [1.0, 0.0]


def test_a_size_that_is_too_short_is_one_error() -> None:
    found = read_mjcf(SourceText("arm.xml", one("", '<geom type="capsule" size=".02"/>')))
    (error,) = [one.message for one in found.findings if one.is_error]
    assert error.startswith("a measure of `capsule` is 0 m")


@pytest.mark.parametrize("kind", ["capsule", "box", ""])
def test_geometry_that_is_fitted_to_a_mesh_is_named(kind: str) -> None:
    said = f'type="{kind}"' if kind else ""
    found = read(one("", f'<geom {said} mesh="m"/>', '<asset><mesh name="m" file="m.stl"/></asset>'))
    data = {key: names for finding in found.findings for key, names in finding.data.items()}
    assert data["geometry fitted to meshes"] == (kind or "sphere",)
    assert data["weights of meshes"] == ("body_2",)


def test_an_element_has_a_bounded_number_of_attributes() -> None:
    many = " ".join(f'k{place}="1"' for place in range(MOST_ATTRIBUTES + 1))
    found = read_mjcf(SourceText("arm.xml", one(f"<geom {many}/>")))
    assert [one.code for one in found.findings if one.is_error] == ["X981"]


def classes(count: int, keys: int) -> str:
    """Return an arm with so many classes, and with so many attributes that the geometry of all has."""
    many = " ".join(f'k{place}="1"' for place in range(keys))
    inner = "".join(f'<default class="a{place}"><geom rgba="1 0 0 1"/></default>' for place in range(count))
    geoms = "".join(f'<geom class="a{place}" size="0.1"/>' for place in range(count))
    default = f"<default><geom {many}/>{inner}</default><worldbody>"
    return ARM.replace("<worldbody>", default).replace('<body name="b"', f'{geoms}<body name="b"')


def test_memory_of_classes_does_not_grow_with_the_attributes_that_they_inherit() -> None:
    read(ARM)  # what is loaded once
    few, many = (peak_of(partial(read, classes(500, keys))) for keys in (1, 900))
    assert many - few < 2_000_000  # bytes; a copy of 900 names for each class takes 37 kB, 18 MB for all


def test_work_on_a_row_does_not_grow_with_the_numbers_that_it_has_too_many() -> None:
    def read_row(count: int) -> None:
        row = " ".join(["1"] * count)
        found = read_mjcf(SourceText("arm.xml", one("", f'<geom type="box" size="{row}"/>')))
        assert next(one.code for one in found.findings if one.is_error) == "X983"

    read_row(5)  # what is loaded once
    few, many = (calls_of(partial(read_row, count)) for count in (5, 9_000))
    assert many - few < 100  # each number takes three calls
