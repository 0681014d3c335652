"""The scene description of a cell, as plain values for the page that draws it.

All poses are in the world frame W, z up, or in the frame of the body that carries the thing; lengths in m.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ropsim.flow import channel_name
from ropsim.model import WORLD, Cell, Frame, Mesh, Station, link_name
from ropsim.spatial import Array, Pose
from ropsim.views.scene.arm import reach
from ropsim.views.scene.bodies import NO_BODY, SceneBody, scene_bodies
from ropsim.views.scene.shapes import MeshSource, corners, plain_pose, plain_shape

VERSION = 2
NO_MESHES: Mapping[Mesh, MeshSource] = MappingProxyType({})


def scene(cell: Cell, meshes: Mapping[Mesh, MeshSource] = NO_MESHES) -> dict[str, object]:
    """Return the scene description of a cell: plain values, without NaN or infinity.

    Args:
        cell: with or without shapes; bodies without shapes get a stand-in.
        meshes: where the page finds each mesh of the cell; one that is not there is drawn as missing.

    Returns:
        `version`, `project`, `stations` with their robots, `bodies` in the order of the body tree, `frames`,
        `signals` and `extent`.
    """
    bodies = scene_bodies(cell)
    return {
        "version": VERSION,
        "project": cell.name,
        "stations": [_station(one) for one in cell.stations.values()],
        "bodies": [_body(body, meshes) for body in bodies],
        "frames": _frames(cell, bodies),
        "signals": [
            {
                "name": signal.name,
                "input": signal.is_input,
                "analog": signal.analog,
                "initial": signal.initial,
            }
            for signal in cell.signals.values()
        ],
        "extent": _extent(cell, bodies, meshes),
    }


def _station(station: Station) -> dict[str, object]:
    robot = station.robot
    joints = [
        {
            "name": joint.name,
            "type": joint.measure.value,
            "lower": joint.lower,
            "upper": joint.upper,
            "maxSpeed": joint.max_speed,
        }
        for joint in robot.axis_joints
    ]
    return {
        "name": station.name,
        "robot": robot.name,
        "title": robot.title,
        "program": station.program,
        "tool": station.default_tool,
        "base": plain_pose(station.X_WB),
        "joints": joints,
    }


def _body(body: SceneBody, meshes: Mapping[Mesh, MeshSource]) -> dict[str, object]:
    return {
        "name": body.name,
        "kind": body.kind.value,
        "parent": body.parent,
        "pose": plain_pose(body.pose),
        "shapes": [plain_shape(shape, meshes) for shape in body.shapes],
        "visible": body.visible,
    }


def _frames(cell: Cell, bodies: tuple[SceneBody, ...]) -> list[dict[str, object]]:
    places, stations = {body.name: place for place, body in enumerate(bodies)}, cell.stations.values()
    marks = [
        ("world", "world", NO_BODY, Pose()),
        *((channel_name("base", one.name), "base", NO_BODY, one.X_WB) for one in stations),
        *((name, "frame", *_hung(one, places)) for name, one in cell.frames.items()),
        *((name, "location", *_located(cell, name, places)) for name in cell.locations),
        *(_tcp(one, places) for one in stations),
    ]
    return [
        {"name": name, "kind": kind, "parent": parent, "pose": plain_pose(pose)}
        for name, kind, parent, pose in marks
    ]


def _hung(frame: Frame, places: Mapping[str, int]) -> tuple[int, Pose]:
    """Return the place of the link that moves a task frame, and its pose there; else that in the world."""
    return places[frame.parent] if frame.parent != WORLD else NO_BODY, frame.X_PK


def _located(cell: Cell, name: str, places: Mapping[str, int]) -> tuple[int, Pose]:
    """Return the place of the link that moves a location, and its pose there; else that in the world."""
    if name not in cell.located:
        return NO_BODY, cell.locations[name]
    link, X_PK = _hung(cell.frames[cell.located[name]], places)
    return link, X_PK @ cell.locations[name]


def _tcp(station: Station, places: Mapping[str, int]) -> tuple[str, str, int, Pose]:
    """Return the mark of the TCP of a station, on its last link."""
    tool, robot = station.tools.get(station.default_tool), station.robot
    X_nT = robot.X_nM @ tool.X_MT if tool else robot.X_nM
    return channel_name("tcp", station.name), "tcp", places[link_name(robot.tip + 1, station.name)], X_nT


def _extent(
    cell: Cell, bodies: tuple[SceneBody, ...], meshes: Mapping[Mesh, MeshSource]
) -> dict[str, list[float]]:
    """Return the box around everything and around the reach of all arms, which stops at the floor."""
    points = np.vstack([np.zeros((1, 3)), *_corners_in_world(bodies, meshes)])
    low, high = points.min(axis=0), points.max(axis=0)
    floor = low[2]
    for station in cell.stations.values():
        shoulder, radius = _reach(station)
        low, high = np.minimum(low, shoulder - radius), np.maximum(high, shoulder + radius)
    low[2] = max(low[2], floor)
    return {"min": low.tolist(), "max": high.tolist()}


def _reach(station: Station) -> tuple[Array, float]:
    """Return centre in W [m], shape (3,), and radius [m] of a sphere that the TCP never leaves."""
    tool = station.tools.get(station.default_tool)
    centre, radius = reach(station.robot)
    radius += float(np.linalg.norm(tool.X_MT.position)) if tool else 0.0
    return (station.X_WB @ Pose(centre)).position, radius


def _corners_in_world(bodies: tuple[SceneBody, ...], meshes: Mapping[Mesh, MeshSource]) -> list[Array]:
    placed = []
    for body in bodies:
        X_WF = body.pose if body.parent == NO_BODY else bodies[body.parent].pose @ body.pose
        rotation = X_WF.rotation().T
        placed += [corners(shape, meshes) @ rotation + X_WF.position for shape in body.shapes]
    return placed
