"""The entities of a station: the built-in ones, and those that modules of the project make."""

from dataclasses import replace
from typing import Any, cast

from ropsim.controller import MODULE_FAILS, ModuleError, made_by_module
from ropsim.model import Cell, Entity, OwnEntity, Station
from ropsim.planning import MotionChain, SensorInterface, standard_chain

_FIELDS = {
    Entity.PATH_PLANNER: ("planner", "plan"),
    Entity.INTERPOLATOR: ("interpolator", "sample"),
    Entity.INVERSE_TRANSFORM: ("inverse", "solve"),
    Entity.JOINT_INTERPOLATOR: ("joint_interpolator", "refine"),
    Entity.PATH_CORRECTOR: ("corrector", "correct"),
}
"""Field of the chain, and the method that it must have."""


def station_chain(cell: Cell, station: Station) -> MotionChain:
    """Return the entities between move instruction and joint controller of a station.

    A module defines a function with the name of the entity, such as `path_planner(standard, cell, station)`,
    which returns one in place of the standard one.

    Raises:
        ModuleError: C628, C629: a module is not trusted, fails, or makes something else.
    """
    chain = standard_chain(cell, station)
    for own in station.controller.entities:
        if own.entity in _FIELDS:
            field, method = _FIELDS[own.entity]
            made = _made(own, method, getattr(chain, field), cell, station)
            chain = replace(chain, **{field: cast("Any", made)})
    return chain


def station_sensors(cell: Cell, station: Station, standard: SensorInterface) -> SensorInterface:
    """Return the sensor interface of a station; see `station_chain`."""
    for own in station.controller.entities:
        if own.entity is Entity.SENSOR_INTERFACE:
            return cast("SensorInterface", _made(own, "read", standard, cell, station))
    return standard


def _made(own: OwnEntity, method: str, standard: object, cell: Cell, station: Station) -> object:
    entry = own.entity.value
    made = made_by_module(own.file, entry, standard, cell, station)
    if not callable(getattr(made, method, None)):
        message = f"`{entry}` of `{own.file.path}` returns {type(made).__name__}"
        hint = f"allowed is an object with the method `{method}`; see docs/how-to/own-planner.md"
        raise ModuleError(MODULE_FAILS.at(None, message, hint=hint))
    return made
