"""Every arm of the house with its standard controller, as random walks take them."""

from dataclasses import replace

from ropsim import robots
from ropsim.controller import MotionChain
from ropsim.model import OrientationMode, on_track
from support.built_in import WRITTEN
from support.cells import chain_of, one_station

ARMS = {name: robots.load(name) for name in WRITTEN} | {
    "puma560 on a track": on_track(robots.load("puma560"), robots.linear_track(4.0))
}
LED = "puma560", "puma560 on a track"


def _chain(name: str, mode: OrientationMode) -> MotionChain:
    controller = replace(robots.default_controller(ARMS[name]), orientation=mode)
    return chain_of(one_station("walk", ARMS[name], controller))


CHAINS: dict[str, MotionChain] = {name: _chain(name, OrientationMode.FIXED_AXIS) for name in ARMS} | {
    f"{name} with wrist angles": _chain(name, OrientationMode.WRIST_ANGLES) for name in LED
}
