"""Entities of a controller that modules of the project make in place of the built-in ones."""

from enum import StrEnum

from ropsim.core import frozen_dataclass
from ropsim.model.law_file import LawFile


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
    file: LawFile
