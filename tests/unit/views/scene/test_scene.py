"""The scene description: what the page expects, in the order of the body tree, all in the world frame."""

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ropsim import robots
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.kinematics import frames_batch, joint_frames
from ropsim.model import (
    Box,
    Cylinder,
    FixedObject,
    Frame,
    Gripper,
    Mesh,
    Part,
    Polyline,
    Prism,
    Revolve,
    Shape,
    Signal,
    Sphere,
    Tool,
    body_tree,
)
from ropsim.spatial import Pose, frozen
from ropsim.views import MeshSource, scene
from support.cells import one_station, with_station

ROUNDING = 1e-12
TYPES = (Path(__file__).parents[4] / "frontend" / "src" / "scene" / "description.ts").read_text("utf-8")

MESH = Mesh("geometry/a.stl", 0.001)
SOLIDS = (
    Box((0.1, 0.2, 0.3)),
    Cylinder(0.1, 0.5, 0.0),
    Sphere(0.2),
    Revolve(((0.0, 0.0), (0.2, 0.1))),
    Prism(((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)), 0.1),
    Polyline(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0))),
    MESH,
)
ARM = robots.load("puma560")
TURNED = Pose(frozen([1.0, 2.0, 0.5]), frozen([1.0, 0.0, 0.0, 1.0]))
JAWS = Tool("jaws", Pose(frozen([0.0, 0.0, 0.2])), gripper=Gripper(0.2, 0.2, 0.005))
PEN = Tool("pen", Pose(frozen([0.05, 0.0, 0.1])))
CELL = one_station(
    name="test",
    robot=ARM,
    controller=robots.default_controller("puma560"),
    X_WB=TURNED,
    tools={"jaws": JAWS, "pen": PEN},
    default_tool="jaws",
    frames={"table": Frame(Pose(frozen([0.5, 0.0, 0.2])))},
    locations={"here": Pose(frozen([0.6, 0.1, 0.3]))},
    parts=(
        Part("first", frozen([0.06, 0.05, 0.04]), 0.1, Pose(frozen([0.5, 0.1, 0.3])), "supply", 0, "#112233"),
        Part("second", frozen([0.06, 0.05, 0.04]), 0.1, Pose(frozen([0.5, 0.1, 0.3])), "supply", 1),
    ),
    objects=(FixedObject("shelf", Pose(frozen([0.7, 0.0, 0.5])), tuple(Shape(solid) for solid in SOLIDS)),),
    signals={"ready": Signal("ready", is_input=True, initial=1.0)},
)
SCENE: Any = scene(CELL)
BODIES: list[Any] = SCENE["bodies"]
PLACES = body_tree(CELL).places()


def matrix(values: list[float]) -> Any:
    return Pose(frozen(values[:3]), frozen(values[3:])).matrix()


def keys_in_types(interface: str) -> set[str]:
    found = re.search(
        rf"interface {interface}(?: extends (\w+))? \{{\n(.*?)^\}}", TYPES, re.MULTILINE | re.DOTALL
    )
    assert found is not None
    own = set(re.findall(r"^  readonly (\w+):", found[2], re.MULTILINE))
    return own | (keys_in_types(found[1]) if found[1] else set())


def test_every_record_has_the_fields_that_the_page_knows() -> None:
    document: Any = scene(CELL)
    assert set(document) == keys_in_types("SceneDescription")
    assert set(document["bodies"][0]) == keys_in_types("Body")
    assert set(document["frames"][0]) == keys_in_types("FrameMark")
    assert set(document["signals"][0]) == keys_in_types("SignalDescription")
    assert set(document["stations"][0]) == keys_in_types("StationDescription")
    assert set(document["stations"][0]["joints"][0]) == keys_in_types("JointDescription")
    (shelf,) = [body for body in document["bodies"] if body["kind"] == "object"]
    interfaces = ("Box", "Cylinder", "Sphere", "Revolve", "Prism", "Line", "Mesh")
    for shape, interface in zip(shelf["shapes"], interfaces, strict=True):
        assert set(shape) == keys_in_types(f"{interface}Shape")
        assert f"readonly kind: '{shape['kind']}'" in TYPES


def test_a_scene_is_strict_json_and_comes_back_the_same() -> None:
    document = scene(CELL)
    assert json.loads(json.dumps(document, allow_nan=False)) == document


def test_the_bodies_come_in_the_order_of_the_body_tree() -> None:
    links = [f"link{i}" for i in range(1, 7)]
    assert list(PLACES) == ["base", *links, "tool:jaws", "tool:pen", "shelf", "first", "second"]
    assert [body["name"] for body in BODIES] == list(PLACES)
    assert [body["kind"] for body in BODIES] == [body.kind for body in body_tree(CELL).bodies]


def test_links_stand_in_the_world_where_the_kinematics_has_them() -> None:
    frames = joint_frames(ARM, ARM.home)
    for place, frame in zip(range(1, 7), frames, strict=False):
        assert BODIES[place]["parent"] == -1
        assert matrix(BODIES[place]["pose"]) == pytest.approx(TURNED.matrix() @ frame, abs=ROUNDING)


def test_the_start_of_the_cell_moves_the_links() -> None:
    q = frozen([0.3, -0.4, 0.2, 0.1, 0.5, -0.6])
    bodies: Any = scene(with_station(CELL, start=q))["bodies"]
    expected = TURNED.matrix() @ joint_frames(ARM, q)[5]
    assert matrix(bodies[6]["pose"]) == pytest.approx(expected, abs=ROUNDING)


def test_tools_ride_on_the_last_link_and_only_the_mounted_one_is_seen() -> None:
    jaws, pen = BODIES[PLACES["tool:jaws"]], BODIES[PLACES["tool:pen"]]
    assert (jaws["parent"], pen["parent"]) == (PLACES["link6"], PLACES["link6"])
    assert (jaws["visible"], pen["visible"]) == (True, False)
    assert jaws["pose"] == pytest.approx(list(ARM.X_nM.as_tuple()), abs=ROUNDING)


def test_a_part_is_a_box_below_its_grasp_point_and_waits_unseen_in_its_supply() -> None:
    first, second = BODIES[PLACES["first"]], BODIES[PLACES["second"]]
    (shape,) = first["shapes"]
    assert (shape["size"], shape["colour"]) == ([0.06, 0.05, 0.04], "#112233")
    assert shape["pose"][:3] == [0.0, 0.0, -0.02]
    assert (first["visible"], second["visible"]) == (True, False)
    expected = CELL.parts[0].X_WO
    assert matrix(first["pose"]) == pytest.approx(expected.matrix(), abs=ROUNDING)


def test_frames_are_marked_in_the_world_and_the_tcp_on_the_last_link() -> None:
    marks: Any = {mark["kind"]: mark for mark in SCENE["frames"]}
    assert marks["world"]["pose"] == list(Pose().as_tuple())
    assert matrix(marks["base"]["pose"]) == pytest.approx(TURNED.matrix(), abs=ROUNDING)
    for kind, X_WK in (("frame", CELL.frames["table"].X_PK), ("location", CELL.locations["here"])):
        assert matrix(marks[kind]["pose"]) == pytest.approx(X_WK.matrix(), abs=ROUNDING)
    assert marks["tcp"]["parent"] == PLACES["link6"]
    assert marks["tcp"]["pose"][:3] == pytest.approx([0.0, 0.0, 0.2], abs=ROUNDING)


def test_a_mesh_that_nobody_has_read_says_so() -> None:
    shelf = BODIES[PLACES["shelf"]]
    assert (shelf["shapes"][-1]["mesh"], shelf["shapes"][-1]["missing"]) == ("", "the file has not been read")


def test_a_mesh_is_given_by_its_address_and_widens_the_extent() -> None:
    source = MeshSource("ab12", "", (0.0, 0.0, 0.0), (0.0, 0.0, 9.0))
    document: Any = scene(CELL, {MESH: source})
    shelf = document["bodies"][PLACES["shelf"]]
    assert (shelf["shapes"][-1]["mesh"], shelf["shapes"][-1]["missing"]) == ("ab12", "")
    assert document["extent"]["max"][2] == pytest.approx(9.5)


def test_the_extent_holds_every_place_that_the_tool_can_reach_above_the_floor() -> None:
    extent: Any = scene(CELL)["extent"]
    rng = np.random.default_rng(3)
    Q = rng.uniform(ARM.lower_limits, ARM.upper_limits, (2000, ARM.n))
    tips = (TURNED.matrix() @ frames_batch(ARM, Q)[:, -1] @ JAWS.X_MT.matrix())[:, :3, 3]
    tips = tips[tips[:, 2] >= 0.0]
    assert (tips >= extent["min"]).all()
    assert (tips <= extent["max"]).all()
    assert extent["min"][2] == 0.0


def test_the_extent_holds_the_corners_of_every_box() -> None:
    far = FixedObject("far", Pose(frozen([5.0, 0.0, -1.0])), (Shape(Box((2.0, 2.0, 2.0))),))
    extent: Any = scene(replace(with_station(CELL, X_WB=Pose()), objects=(far,), parts=()))["extent"]
    assert extent["max"][0] == pytest.approx(6.0)
    assert extent["min"][2] == pytest.approx(-2.0)


def test_what_lies_on_a_positioner_is_marked_on_the_link_that_moves_it() -> None:
    text = (
        '[robot]\nmodel = "puma560"\n'
        "positioner = { radius = 300, height = 500, base = { position = [0, 900, 0] } }\n"
        '[frames.fixture]\nparent = "positioner"\nposition = [100, 0, 20]\n'
        '[locations.corner]\nframe = "fixture"\nposition = [10, 0, 40]\ndown = false\n'
    )
    cell, _ = read_cell(SourceText("cell.toml", text), "cell")
    assert cell is not None
    shown: Any = scene(cell)
    plate = [body["name"] for body in shown["bodies"]].index("link7")
    marks = {mark["name"]: mark for mark in shown["frames"]}
    assert [marks[name]["parent"] for name in ("fixture", "corner")] == [plate, plate]
    assert marks["fixture"]["pose"][:3] == pytest.approx([0.1, 0.0, 0.02], abs=ROUNDING)
    assert marks["corner"]["pose"][:3] == pytest.approx([0.11, 0.0, 0.06], abs=ROUNDING)
