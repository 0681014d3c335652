"""What a live run shows: the layout of its numbers, and state frames of 60 per second."""

import struct

import numpy as np

from ropsim.kinematics import body_poses
from ropsim.model import ROBOT, BodyKind, body_tree
from ropsim.simulation import RunView, live_sample
from ropsim.spatial import Array, quaternions_from_matrices
from ropsim.studio.jobs import LiveFrame, LiveMessage
from ropsim.studio.messages import LiveChannel, LiveLayout, plain

HEADER = struct.Struct("<2sBBIddHHI")
"""Magic, version, kind, number, simulated time [s], wall clock [ms], channel values, bodies, event bits."""

VERSION, STATE = 1, 1


class Frames:
    """Makes the frames of one run.

    Args:
        run: as it starts; its channels are those of all frames.
    """

    def __init__(self, run: RunView) -> None:
        self._sent = 0
        self._tree = body_tree(run.cell)
        self._links = self._tree.names(BodyKind.LINK)
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
        return LiveMessage(plain(LiveLayout(columns, tuple(places[name] for name in self._links))))

    def frame(self, run: RunView, time: float, wall: float) -> LiveFrame:
        """Return the state at a time.

        Args:
            run: must have been computed up to that time.
            time: [s].
            wall: time of day [s].
        """
        sample = live_sample(run, time)
        values = np.concatenate([sample[name].values.ravel() for name in self._layout]).astype("<f4")
        bodies = self._poses(sample["q"].values).astype("<f4")
        self._sent += 1
        counts = (len(values), len(bodies), 0)
        header = HEADER.pack(b"RS", VERSION, STATE, self._sent % 2**32, time, wall * 1e3, *counts)
        return LiveFrame(header + values.tobytes() + bodies.tobytes())

    def _poses(self, q: Array) -> Array:
        """Return position and quaternion of every link in W, shape (n, 7)."""
        frames = np.concatenate(list(body_poses(self._tree, {ROBOT: q}, self._links).values()))
        return np.hstack((frames[:, :3, 3], quaternions_from_matrices(frames[:, :3, :3])))
