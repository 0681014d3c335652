"""Masses and drives of library arms: facts, and estimates made from tools/library_estimates.toml.

Masses are rounded, as their last digits depend on the processor that turned them into the frames of links.
"""

import tomllib
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any

from ropsim.core import Diagnostic
from ropsim.model import OriginKind, ParameterOrigin, RobotModel
from ropsim.robotfile import ArmFacts, TorqueTrust, estimated_dynamics
from ropsim.spatial import frozen, without_residues

DIGITS = 12
INPUTS = Path(__file__).parent / "library_estimates.toml"


def driven(robots: dict[str, RobotModel]) -> dict[str, RobotModel]:
    """Return robots with masses, torque limits and drives; arms that have all of them stay as they are.

    Raises:
        ValueError: estimates cannot be made for one, or an input belongs to none.
    """
    inputs: dict[str, dict[str, Any]] = tomllib.loads(INPUTS.read_text("utf-8"))
    strays = inputs.keys() - robots.keys()
    if strays:
        raise ValueError(f"{INPUTS.name}: no robot is called {', '.join(sorted(strays))}")
    return {
        name: rounded(_driven(robot, inputs[name]) if name in inputs else robot)
        for name, robot in robots.items()
    }


def rounded(robot: RobotModel) -> RobotModel:
    """Return a robot whose centres of mass and tensors have 12 significant digits and no residues."""
    links = tuple(
        replace(
            link,
            com=frozen(without_residues(link.com, DIGITS)),
            inertia=frozen(without_residues(link.inertia, DIGITS)),
        )
        for link in robot.links
    )
    return replace(robot, links=links)


def _driven(robot: RobotModel, row: dict[str, Any]) -> RobotModel:
    facts = ArmFacts(
        total_mass=float(row.get("total_mass", inf)),
        mass_source=row.get("mass_source", ""),
        payload=float(row.get("payload", inf)),
        rotors=tuple(map(float, row.get("rotors", ()))),
        ratios=tuple(map(float, row.get("ratios", ()))),
        trust=TorqueTrust(row.get("torques", "file")),
    )
    if "rotors" in row:
        origin = ParameterOrigin("rotors and gears", OriginKind(row["rotor_kind"]), row["rotor_source"])
        robot = replace(robot, origins=(*robot.origins, origin))
    made = estimated_dynamics(robot, facts)
    if isinstance(made, Diagnostic):
        raise ValueError(f"{robot.name}: {made.message}")  # noqa: TRY004 - facts are missing, no type is wrong
    return made
