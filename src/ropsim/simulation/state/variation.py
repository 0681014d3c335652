"""Variations of the numbers of an arm and of its gains, of which none needs other code."""

from collections.abc import Mapping
from dataclasses import field, fields, replace
from math import isfinite
from types import MappingProxyType
from typing import Any

import numpy as np

from ropsim.controller import CompiledLaw
from ropsim.model import BacklashGear, Drive, ElasticGear, Hydraulic, Payload, RobotModel
from ropsim.simulation.servo.diagnostics import BAD_OPTIONS, OptionError
from ropsim.spatial import record

_FRICTION = frozenset(
    {"viscous", "coulomb", "coulomb_positive", "coulomb_negative", "breakaway", "load_share"}
)
"""Numbers of friction that are torques, or grow as they do."""


@record
class Variation:
    """One choice of numbers in a study; all factors are above 0, and 1 leaves a number as it is.

    Attributes:
        masses: factor on the masses of the links, and on their inertias.
        friction: factor on dry and viscous friction of all drives.
        stiffness: factor on the stiffness of elastic gears, and on that of the oil.
        gains: factors on parameters of the law, by their names, such as `kp`.
        payload: body at the mechanical interface; None for that of the study.
    """

    masses: float = 1.0
    friction: float = 1.0
    stiffness: float = 1.0
    gains: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    payload: Payload | None = None

    def __post_init__(self) -> None:
        for name in ("masses", "friction", "stiffness"):  # numbers of numpy, too
            object.__setattr__(self, name, float(getattr(self, name)))


def without_shapes(robot: RobotModel) -> RobotModel:
    """Return an arm without its looks: it moves as before, and is compared by content more quickly."""
    return replace(robot, links=tuple(replace(one, shapes=()) for one in robot.links), base_shapes=())


def varied_robot(robot: RobotModel, variation: Variation) -> RobotModel:
    """Return an arm with the numbers of a variation; the same one where they leave it as it is.

    Raises:
        OptionError: S703, a factor is not above 0.
    """
    factors = variation.masses, variation.friction, variation.stiffness
    for name, factor in zip(("masses", "friction", "stiffness"), factors, strict=True):
        _check_factor(name, factor)
    if factors == (1.0, 1.0, 1.0):
        return robot
    masses = variation.masses
    links = tuple(
        replace(one, mass=masses * one.mass, inertia=masses * one.inertia) if masses != 1.0 else one
        for one in robot.links
    )
    return replace(robot, links=links, drives=tuple(_varied_drive(one, variation) for one in robot.drives))


def varied_law(law: CompiledLaw, variation: Variation) -> CompiledLaw:
    """Return a law with the gains of a variation; it believes the same of its arm.

    Raises:
        OptionError: S703, a factor is not above 0, or no parameter has its name.
    """
    if not variation.gains:
        return law
    parameters = np.array(law.parameters)
    for name, factor in variation.gains.items():
        _check_factor(name, factor)
        if name not in law.parameter_names:
            known = ", ".join(f"`{one}`" for one in law.parameter_names[:12]) or "none"
            more = ", …" if len(law.parameter_names) > 12 else ""
            message = f"law `{law.name}` has no parameter `{name}`"
            raise OptionError(BAD_OPTIONS.at(None, message, hint=f"it has {known}{more}"))
        parameters[law.parameter_names.index(name)] *= factor
    return replace(law, parameters=parameters)


def _varied_drive(drive: Drive, variation: Variation) -> Drive:
    changed: dict[str, Any] = {}
    if variation.friction != 1.0:
        names = [one.name for one in fields(drive.friction) if one.name in _FRICTION]
        scaled = {name: variation.friction * getattr(drive.friction, name) for name in names}
        changed["friction"] = replace(drive.friction, **scaled)
    gear, motor, factor = drive.transmission, drive.motor, variation.stiffness
    if factor != 1.0 and isinstance(gear, ElasticGear | BacklashGear):
        changed["transmission"] = replace(gear, stiffness=factor * gear.stiffness)
    if factor != 1.0 and isinstance(motor, Hydraulic):
        changed["motor"] = replace(motor, bulk_modulus=factor * motor.bulk_modulus)
    return replace(drive, **changed) if changed else drive


def _check_factor(name: str, factor: float) -> None:
    if not (isfinite(factor) and factor > 0.0):
        message = f"the factor on `{name}` is {factor!r}; allowed are numbers above 0"
        raise OptionError(BAD_OPTIONS.at(None, message, hint="1 leaves the number as it is"))
