"""Entities of a controller: built-in ones that a cell names, and those that modules of the project make."""

from enum import StrEnum

from ropsim.core import frozen_dataclass
from ropsim.model.controller_file import ControllerFile


class Entity(StrEnum):
    """The entities that a project can replace, besides the joint controller; in the order of their work.

    The value is the key in a cell file and the name of the function of the module.
    """

    PATH_PLANNER = "path_planner"
    INTERPOLATOR = "interpolator"
    INVERSE_TRANSFORM = "inverse_transform"
    JOINT_INTERPOLATOR = "joint_interpolator"
    PATH_CORRECTOR = "path_corrector"
    SENSOR_INTERFACE = "sensor_interface"


@frozen_dataclass
class OwnEntity:
    """An entity from a module of the project.

    Attributes:
        entity: that it replaces.
        file: the module.
    """

    entity: Entity
    file: ControllerFile


@frozen_dataclass
class NamedEntity:
    """A built-in entity in place of the standard one.

    Attributes:
        entity: that it replaces.
        name: of the built-in one, see `planning.BUILT_IN`.
    """

    entity: Entity
    name: str
