"""The scene description: what a cell looks like, as plain values for the page that draws it.

All poses are in the world frame W, z up, or in the frame of the body that carries the thing; lengths in m.
"""

from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from ropsim.model import Cell, Mesh
from ropsim.spatial import Array, Pose
from ropsim.views.scene.arm import reach
from ropsim.views.scene.bodies import NO_BODY, SceneBody, scene_bodies
from ropsim.views.scene.shapes import MeshSource, corners, plain_pose, plain_shape

VERSION = 1
NO_MESHES: Mapping[Mesh, MeshSource] = MappingProxyType({})


def scene(cell: Cell, meshes: Mapping[Mesh, MeshSource] = NO_MESHES) -> dict[str, object]:
    """Return the scene description of a cell: plain values, without NaN or infinity.

    Args:
        cell: with or without shapes; what has none gets a stand-in.
        meshes: where the page finds each mesh of the cell; one that is not there is drawn as missing.

    Returns:
        `version`, `project`, `robot`, `bodies` in the order of the body tree, `frames`, `signals`,
        `base` (X_WB) and `extent`.
    """
    bodies = scene_bodies(cell)
    return {
        "version": VERSION,
        "project": cell.name,
        "robot": _robot(cell),
        "bodies": [_body(body, meshes) for body in bodies],
        "frames": _frames(cell),
        "signals": [
            {
                "name": signal.name,
                "input": signal.is_input,
                "analog": signal.analog,
                "initial": signal.initial,
            }
            for signal in cell.signals.values()
        ],
        "base": plain_pose(cell.first.X_WB),
        "extent": _extent(cell, bodies, meshes),
    }


def _robot(cell: Cell) -> dict[str, object]:
    robot = cell.first.robot
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
    return {"name": robot.name, "title": robot.title, "joints": joints}


def _body(body: SceneBody, meshes: Mapping[Mesh, MeshSource]) -> dict[str, object]:
    return {
        "name": body.name,
        "kind": body.kind.value,
        "parent": body.parent,
        "pose": plain_pose(body.pose),
        "shapes": [plain_shape(shape, meshes) for shape in body.shapes],
        "visible": body.visible,
    }


def _frames(cell: Cell) -> list[dict[str, object]]:
    tool = cell.first.tools.get(cell.first.default_tool)
    X_nT = cell.first.robot.X_nM @ tool.X_MT if tool else cell.first.robot.X_nM
    marks = [
        ("world", "world", NO_BODY, Pose()),
        ("base", "base", NO_BODY, cell.first.X_WB),
        *((name, "frame", NO_BODY, X_WK) for name, X_WK in cell.frames.items()),
        *((name, "location", NO_BODY, X_WT) for name, X_WT in cell.locations.items()),
        ("tcp", "tcp", cell.first.robot.tip + 1, X_nT),
    ]
    return [
        {"name": name, "kind": kind, "parent": parent, "pose": plain_pose(pose)}
        for name, kind, parent, pose in marks
    ]


def _extent(
    cell: Cell, bodies: tuple[SceneBody, ...], meshes: Mapping[Mesh, MeshSource]
) -> dict[str, list[float]]:
    """Return the box around everything and around the reach of the arm, which stops at the floor."""
    tool = cell.first.tools.get(cell.first.default_tool)
    centre, radius = reach(cell.first.robot)
    radius += float(np.linalg.norm(tool.X_MT.position)) if tool else 0.0
    shoulder = (cell.first.X_WB @ Pose(centre)).position
    points = np.vstack([np.zeros((1, 3)), *_corners_in_world(bodies, meshes)])
    low, high = points.min(axis=0), points.max(axis=0)
    floor = low[2]
    low, high = np.minimum(low, shoulder - radius), np.maximum(high, shoulder + radius)
    low[2] = max(low[2], floor)
    return {"min": low.tolist(), "max": high.tolist()}


def _corners_in_world(bodies: tuple[SceneBody, ...], meshes: Mapping[Mesh, MeshSource]) -> list[Array]:
    placed = []
    for body in bodies:
        X_WF = body.pose if body.parent == NO_BODY else bodies[body.parent].pose @ body.pose
        rotation = X_WF.rotation().T
        placed += [corners(shape, meshes) @ rotation + X_WF.position for shape in body.shapes]
    return placed
