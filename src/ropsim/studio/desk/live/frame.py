"""Output of a live run: the layout of its numbers, and state frames of 60 per second."""

import struct
from collections.abc import Mapping

import numpy as np

from ropsim.flow import Channel, channel_name
from ropsim.icr import Program
from ropsim.kinematics import body_poses
from ropsim.model import body_tree
from ropsim.simulation import RunView, live_sample
from ropsim.spatial import Array, quaternions_from_matrices
from ropsim.studio.wire.live_messages import LiveChannel, LiveLayout, LiveStation
from ropsim.studio.wire.messages import plain
from ropsim.studio.wire.replies import LiveFrame, LiveMessage

HEADER = struct.Struct("<2sBBIddHHI")
"""Magic, version, kind, number, simulated time [s], wall clock [ms], channel values, bodies, event bits."""

VERSION, STATE = 1, 1


class Frames:
    """Makes the frames of one run.

    Args:
        run: as it starts; its channels are the channels of all frames.
        programs: programs of the stations.
    """

    def __init__(self, run: RunView, programs: Mapping[str, Program]) -> None:
        self._sent = 0
        self._stations = tuple(_station(name, programs.get(name)) for name in run.stations)
        self._tree = body_tree(run.cell)
        self._moving = self._tree.moving()
        self._layout = live_sample(run, 0.0)

    def layout(self) -> LiveMessage:
        """Return the message that names the numbers of the frames."""
        columns = tuple(
            LiveChannel(
                name,
                column,
                channel.unit,
                channel.description,
                channel.group.value,
                channel.subject,
                channel.held,
            )
            for name, channel in self._layout.items()
            for column in channel.columns or ("",)
        )
        places = self._tree.places()
        bodies = tuple(places[name] for name in self._moving)
        return LiveMessage(plain(LiveLayout(columns, bodies, self._stations)))

    def frame(self, run: RunView, time: float, wall: float) -> LiveFrame:
        """Return the state at a time.

        Args:
            run: must have been computed up to that time.
            time: [s].
            wall: time of day [s].
        """
        sample = live_sample(run, time)
        values = np.concatenate([sample[name].values.ravel() for name in self._layout]).astype("<f4")
        bodies = self._poses(sample).astype("<f4")
        self._sent += 1
        counts = (len(values), len(bodies), 0)
        header = HEADER.pack(b"RS", VERSION, STATE, self._sent % 2**32, time, wall * 1e3, *counts)
        return LiveFrame(header + values.tobytes() + bodies.tobytes())

    def _poses(self, sample: Mapping[str, Channel]) -> Array:
        """Return position and quaternion in W of all bodies moved by joints, shape (n, 7)."""
        q = {name: sample[channel_name("q", name)].values for name in self._tree.mechanisms}
        frames = np.concatenate(list(body_poses(self._tree, q, self._moving).values()))
        return np.hstack((frames[:, :3, 3], quaternions_from_matrices(frames[:, :3, :3])))


def _station(name: str, program: Program | None) -> LiveStation:
    return LiveStation(name, program.name if program else "", program.source if program else "")
