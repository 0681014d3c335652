"""Write the robots of the library, src/ropsim/robots/arms/NAME.stp, from facts, tools/library/NAME.toml.

python -m tools.robot_library           write them
python -m tools.robot_library --check   compare only; exit 1 where one differs

The facts are robot files (docs/reference/robot-file.md), each with the sources of its numbers. Masses and
drives that are not among them are estimates (tools/library_dynamics.py). What the arms look like is in
tools/library_looks.toml: castings of a size, or rods between points on the axes of their
joints. Beside the files stands index.tsv, each built-in robot in a line, so that listing them reads none.
"""

import sys
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from tools.industrial_looks import industrial
from tools.library_chains import chain
from tools.library_dynamics import driven
from tools.library_index import entry
from tools.library_palletizers import palletizer
from tools.library_rods import with_rod

from ropsim.core import SourceText
from ropsim.kinematics import joint_frames
from ropsim.model import Linkage, OriginKind, ParameterOrigin, RobotModel, Shape, rod
from ropsim.nirox import write_nirox
from ropsim.robotfile import read_robot_file
from ropsim.robots import INDEX, catalogue_text, load, names
from ropsim.spatial import Array

ROOT = Path(__file__).parent.parent
FACTS = ROOT / "tools" / "library"
LOOKS = ROOT / "tools" / "library_looks.toml"
TARGET = ROOT / "src" / "ropsim" / "robots" / "arms"
DRAWN = ParameterOrigin("drawn shapes", OriginKind.ESTIMATED, "round rods along and between the axes, by eye")
CASTINGS = ParameterOrigin("drawn shapes", OriginKind.ESTIMATED, "castings around the axes, by eye")


def robots() -> dict[str, RobotModel]:
    """Return the robots of all facts, by name.

    Raises:
        ValueError: a file of facts is wrong, or doubtful, or nothing says what the arm looks like.
    """
    looks = tomllib.loads(LOOKS.read_text("utf-8"))
    found = {}
    for path in sorted(FACTS.glob("*.toml")):
        read = read_robot_file(SourceText(path.name, path.read_text("utf-8")))
        if read.robot is None or read.findings:
            raise ValueError(f"{path.name}: {'; '.join(one.message for one in read.findings)}")
        found[path.stem] = drawn(read.robot, look_of(path, looks))
    found |= {path.stem: palletizer(path) for path in sorted(FACTS.glob("palletizers/*.toml"))}
    for path in sorted(FACTS.glob("chains/*.toml")):
        found[path.stem] = drawn(chain(path), look_of(path, looks))
    return driven(found)


def look_of(facts: Path, looks: Mapping[str, Any]) -> Mapping[str, Any]:
    """Return the table of what a robot looks like.

    Args:
        facts: its file.
        looks: the file of looks.

    Raises:
        ValueError: it has no such table.
    """
    if facts.stem not in looks:
        raise ValueError(f"{facts.name}: no table [{facts.stem}] in {LOOKS.name} says what it looks like")
    look: Mapping[str, Any] = looks[facts.stem]
    return look


def drawn(robot: RobotModel, look: Mapping[str, Any]) -> RobotModel:
    """Return a robot with the castings or rods of its look.

    Args:
        robot: a serial arm; cranks of coupled axes stand behind its links.
        look: its table in the file of looks, which says what the keys mean.
    """
    seen = (
        _with(robot, industrial(robot, look), CASTINGS)
        if look.get("style") == "industrial"
        else _with(robot, _rods(robot, look), DRAWN)
    )
    return with_rod(seen, look["rod"], look["tones"]) if "rod" in look else seen


def _rods(robot: RobotModel, look: Mapping[str, Any]) -> Sequence[Sequence[Shape]]:
    frames = joint_frames(robot, np.zeros(robot.n))
    X_B = np.array([np.eye(4), *frames[: robot.n], frames[-1]])
    bodies: list[list[Shape]] = [[] for _ in range(robot.n + 1)]
    for one in look["rods"]:
        X_LB = np.linalg.inv(X_B[one["link"]])
        ends = (
            _bracket(robot, X_B, one)
            if "pin" in one
            else (_point(X_B, *one["from"]), _point(X_B, *one["to"]))
        )
        first, last = (np.round(X_LB @ end, 9)[:3] + 0.0 for end in ends)
        radius, top = (1e-3 * value for value in one["radii"])
        bodies[one["link"]].append(rod(first, last, radius, top, look["tones"][one["tone"]]))
    return bodies


def _with(robot: RobotModel, bodies: Sequence[Sequence[Shape]], origin: ParameterOrigin) -> RobotModel:
    """Return a robot that looks so: shapes of the base, then of each link of its axes."""
    links = [
        replace(link, shapes=tuple(body))
        for link, body in zip(robot.links[: robot.n], bodies[1:], strict=True)
    ]
    every = (*links, *robot.links[robot.n :])
    return replace(robot, links=every, base_shapes=tuple(bodies[0]), origins=(*robot.origins, origin))


def _point(X_B: Array, axis: int, place: float) -> Array:
    """Return a point on an axis in the base frame [m], shape (4,), homogeneous.

    Args:
        X_B: frames of base, joints and interface where all coordinates are 0, shape (n + 2, 4, 4).
        axis: number of the frame.
        place: from its origin towards that of the frame before, or along z [mm].
    """
    z, origin = X_B[axis, :, 2], X_B[axis, :, 3]
    is_backwards = 0 < axis < len(X_B) - 1 and float(z @ (X_B[axis - 1, :, 3] - origin)) < -1e-6
    return np.asarray(origin + (-1e-3 if is_backwards else 1e-3) * place * z)


def _bracket(robot: RobotModel, X_B: Array, one: Mapping[str, Any]) -> tuple[Array, Array]:
    """Return the ends of a bracket: a pin of a cylinder and its foot on the way between two frames, in B."""
    gear, joint = robot.drives[one["pin"]].transmission, robot.joints[one["pin"]]
    if not isinstance(gear, Linkage):
        raise TypeError(f"{robot.name}: drive {one['pin']} has no pins")
    on_link = one["link"] == one["pin"] + 1
    carrier = X_B[joint.parent + 1] @ joint.placement.matrix()
    pin = (X_B[one["pin"] + 1] @ [*gear.link_pin, 1.0]) if on_link else carrier @ [*gear.carrier_pin, 1.0]
    begin, end = (X_B[number][:3, 3] for number in one["along"])
    share = (pin[:3] - begin) @ (end - begin) / ((end - begin) @ (end - begin))
    return np.append(begin + share * (end - begin), 1.0), pin


def texts() -> dict[str, str]:
    """Return the files of the library by name.

    Raises:
        ValueError: a robot cannot be written, or not without a loss.
    """
    made = robots()
    written = {name: write_nirox(robot) for name, robot in made.items()}
    for name, one in written.items():
        if not one.text or one.losses:
            raise ValueError(f"{name}: {'; '.join(loss.message for loss in one.losses)}")
    everyone = {**{name: load(name) for name in names() if not (TARGET / f"{name}.stp").exists()}, **made}
    index = catalogue_text(tuple(entry(everyone[name]) for name in sorted(everyone)))
    return {**{f"{name}.stp": one.text for name, one in written.items()}, INDEX: index}


def main(arguments: list[str]) -> int:
    """Write or check the files; return the exit code."""
    try:
        wanted = texts()
    except ValueError as error:
        print(error)
        return 1
    there = {path.name: path.read_text("utf-8") for path in TARGET.iterdir()}
    if arguments == ["--check"]:
        names = wanted.keys() | there.keys()
        stale = sorted(name for name in names if wanted.get(name) != there.get(name))
        if stale:
            print(f"stale: {', '.join(stale)}; run python -m tools.robot_library")
        return int(bool(stale))
    for name in there.keys() - wanted.keys():
        (TARGET / name).unlink()
    for name, text in wanted.items():
        (TARGET / name).write_text(text, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
