"""Built-in entities by the names of the cell file: another one is a file and an entry here."""

from collections.abc import Callable, Mapping
from functools import partial
from types import MappingProxyType

from ropsim.model import Entity
from ropsim.motion import TIME_LAWS
from ropsim.planning.built_in.damped_inverse import damped_least_squares
from ropsim.planning.built_in.fine_interpolation import cubics, fine_by, lines
from ropsim.planning.built_in.integral_corrector import proportional_integral
from ropsim.planning.built_in.stops_and_time_laws import exact_stops, timed_by
from ropsim.planning.records.motion_chain import MotionChain

Choice = Callable[[MotionChain], MotionChain]
"""Returns a chain with another entity in the place of the standard one."""


def _standard(chain: MotionChain) -> MotionChain:
    return chain


BUILT_IN: Mapping[Entity, Mapping[str, Choice]] = MappingProxyType(
    {
        Entity.INTERPOLATOR: {name: partial(timed_by, name) for name in TIME_LAWS},
        Entity.PATH_PLANNER: {"rounded corners": _standard, "exact stops": exact_stops},
        Entity.INVERSE_TRANSFORM: {"closed form": _standard, "damped least squares": damped_least_squares},
        Entity.JOINT_INTERPOLATOR: {
            "every tick": _standard,
            "linear": partial(fine_by, lines),
            "cubic": partial(fine_by, cubics),
        },
        Entity.PATH_CORRECTOR: {"proportional": _standard, "proportional integral": proportional_integral},
        Entity.SENSOR_INTERFACE: {},
    }
)
"""Entity -> name of a built-in one -> what it does to a chain; the standard one is the first.

They come into the chain in this order: the time law of the interpolator first, since it changes the limits
of the joints for the others. Time laws have a table of their own, `motion.TIME_LAWS`. Sensors are chosen
channel by channel.
"""
