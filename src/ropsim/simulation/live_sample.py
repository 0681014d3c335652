"""What a run that still goes on would record at one time: the same channels, one row."""

from collections.abc import Mapping

import numpy as np

from ropsim.flow import Channel
from ropsim.kinematics import forward_batch
from ropsim.model import ROBOT
from ropsim.simulation.channels import joint_channels, pose_channels, track_channel
from ropsim.simulation.track import Track
from ropsim.simulation.watch import RunView
from ropsim.spatial import Pose


def live_sample(run: RunView, time: float) -> Mapping[str, Channel]:
    """Return the channels at a time up to the present one, each with one row.

    Names, units and columns are those of the recording that the run will leave; `path_error` is not there,
    it is known when a move is over.

    Args:
        run: still going on.
        time: [s].
    """
    tick = time * run.cell.controller.rates.control_hz
    log = {name: values[np.newaxis] for name, values in run.plant.at(tick).items()}
    log["q_error"] = log["q_ref"] - log["q"]
    X_MT = tool_pose(run, tick).matrix()
    channels = joint_channels(ROBOT, run.cell.robot, log)
    channels |= pose_channels(ROBOT, "attained", forward_batch(run.cell.robot, log["q"]) @ X_MT)
    channels |= pose_channels(ROBOT, "command", forward_batch(run.cell.robot, log["q_ref"]) @ X_MT)
    for name in sorted(run.tracks):
        held = Track([0], [run.tracks[name].value(tick)])
        channels[name] = track_channel(ROBOT, name, held, 0, run.cell.controller.rates.control_hz)
    return channels


def tool_pose(run: RunView, tick: float) -> Pose:
    """Return X_MT of the latest move that has begun by a tick; before the first one that of the tool."""
    for move in reversed(run.moves[-2:]):
        if move.start <= tick:
            return move.X_MT
    if run.moves:
        return run.moves[-1].X_MT
    return run.tool.X_MT if run.tool else Pose()
