"""Combined usage of a robot and its cell by procedures."""

from collections.abc import Iterable
from itertools import chain

from ropsim.core import frozen_dataclass
from ropsim.icr import IoChannel
from ropsim.program.lowering.procedure import Lowered


@frozen_dataclass
class Usage:
    """Usage of some procedures.

    Attributes:
        channels: by name, each once.
        tools: by name, each once.
        frames: by name, each once.
        lists: of poses by name, each once.
        axes: how many joint coordinates the values of the first procedure have that has some, None for none.
        has_guessed_axes: whether one has values of joint coordinates whose number only others determine.
        capabilities: required capabilities of a robot, sorted.
    """

    channels: tuple[IoChannel, ...]
    tools: tuple[str, ...]
    frames: tuple[str, ...]
    lists: tuple[str, ...]
    axes: int | None
    has_guessed_axes: bool
    capabilities: tuple[str, ...]


def joint_usage(parts: Iterable[Lowered | Usage]) -> Usage:
    """Return the combined usage of procedures or parts of one."""
    every = tuple(parts)
    return Usage(
        tuple({one.name: one for part in every for one in part.channels}.values()),
        tuple(dict.fromkeys(chain.from_iterable(one.tools for one in every))),
        tuple(dict.fromkeys(chain.from_iterable(one.frames for one in every))),
        tuple(dict.fromkeys(chain.from_iterable(one.lists for one in every))),
        next((one.axes for one in every if one.axes is not None), None),
        any(one.has_guessed_axes for one in every),
        tuple(sorted(set(chain.from_iterable(one.capabilities for one in every)))),
    )
