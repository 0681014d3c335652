"""Every arm of the house with its standard controller, as random walks take them."""

from ropsim import robots
from ropsim.controller import MotionChain
from ropsim.model import on_track
from support.cells import chain_of, one_station

ARMS = {name: robots.load(name) for name in robots.names()} | {
    "puma560 on a track": on_track(robots.load("puma560"), robots.linear_track(4.0))
}
CHAINS: dict[str, MotionChain] = {
    name: chain_of(one_station("walk", arm, robots.default_controller(arm))) for name, arm in ARMS.items()
}
