"""Entities of a controller: built-in ones that a cell names, and those that modules of the project make."""

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType

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


class BuiltIn(StrEnum):
    """A built-in entity; the value is its name in a cell file.

    Of the path planner: paths go round their corners within the zones of the program, or stop at each target.
    Of the interpolator: it limits the jerk along a path, or the acceleration alone. Of the inverse transform:
    it has the joints from the closed form of the arm, or step by step with damping. Of the joint
    interpolator: references at every control tick from the path itself, or only at the interpolation ticks
    with straight lines or cubics between. Of the path corrector: the speed of the shift is in proportion to
    the difference, or to it and its integral.
    """

    ROUNDED_CORNERS = "rounded corners"
    EXACT_STOPS = "exact stops"
    JERK_LIMITED = "jerk-limited"
    TRAPEZOIDAL = "trapezoidal"
    CLOSED_FORM = "closed form"
    DAMPED_LEAST_SQUARES = "damped least squares"
    EVERY_TICK = "every tick"
    LINEAR = "linear"
    CUBIC = "cubic"
    PROPORTIONAL = "proportional"
    PROPORTIONAL_INTEGRAL = "proportional integral"


BUILT_IN: Mapping[Entity, tuple[BuiltIn, ...]] = MappingProxyType(
    {
        Entity.PATH_PLANNER: (BuiltIn.ROUNDED_CORNERS, BuiltIn.EXACT_STOPS),
        Entity.INTERPOLATOR: (BuiltIn.JERK_LIMITED, BuiltIn.TRAPEZOIDAL),
        Entity.INVERSE_TRANSFORM: (BuiltIn.CLOSED_FORM, BuiltIn.DAMPED_LEAST_SQUARES),
        Entity.JOINT_INTERPOLATOR: (BuiltIn.EVERY_TICK, BuiltIn.LINEAR, BuiltIn.CUBIC),
        Entity.PATH_CORRECTOR: (BuiltIn.PROPORTIONAL, BuiltIn.PROPORTIONAL_INTEGRAL),
        Entity.SENSOR_INTERFACE: (),
    }
)
"""The built-in entities, the standard one first; sensors are chosen channel by channel."""
