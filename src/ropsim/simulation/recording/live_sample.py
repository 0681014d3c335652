"""Record of a running program at one time: the same channels, one row."""

from collections.abc import Mapping

import numpy as np

from ropsim.flow import Channel, channel_name
from ropsim.kinematics import forward_batch
from ropsim.simulation.recording.channels import (
    device_channel,
    finger_channel,
    joint_channels,
    pose_channels,
    track_channel,
    wrench_channel,
)
from ropsim.simulation.records.plant import CONTACT_WRENCH
from ropsim.simulation.records.track import Track
from ropsim.simulation.servo.log import drive_powers
from ropsim.simulation.state.station_run import StationRun
from ropsim.simulation.state.watch import RunView
from ropsim.spatial import quaternions_from_matrices


def live_sample(run: RunView, time: float) -> Mapping[str, Channel]:
    """Return the channels at a time up to the present one, each with one row.

    Names, units and columns are as in the recording of the run; `path_error` is missing, since it is known
    only after a move.

    Args:
        run: still going on.
        time: [s].
    """
    channels: dict[str, Channel] = {}
    for name, at in run.stations.items():
        own = _station_sample(at, time * at.hz)
        channels |= {channel_name(quantity, name): channel for quantity, channel in own.items()}
    for at in run.stations.values():
        for body, profile in at.fingers.items():
            channels[channel_name("q", body)] = finger_channel(
                at.station.name, profile.rows(np.array([time]))
            )
    for name, device in run.devices.items():
        q = device.profile.rows(np.array([time]))
        channels[channel_name("q", name)] = device_channel(device.device, q)
    tracks = {"override": Track([0], [1.0]), **run.tracks}  # it may change at any time
    for name in sorted(tracks):
        channels[name] = _held("", name, tracks[name], time * run.hz)
    return channels


def _station_sample(at: StationRun, tick: float) -> dict[str, Channel]:
    """Return the channels of a station at a tick, without its name before theirs."""
    robot = at.station.robot
    log = {name: values[np.newaxis] for name, values in at.plant.at(tick).items()}
    log["q_error"] = log["q_ref"] - log["q"]
    log |= drive_powers(robot, log)
    X_MT, name = at.tool_frames.at(tick).matrix(), at.station.name
    poses: dict[str, Channel] = {}
    for kind, one in (("attained", "q"), ("command", "q_ref")):
        matrices = forward_batch(robot, log[one]) @ X_MT
        turned = quaternions_from_matrices(matrices[:, :3, :3])
        poses |= pose_channels(name, kind, np.ascontiguousarray(matrices[:, :3, 3]), turned)
    if CONTACT_WRENCH in log:
        poses[CONTACT_WRENCH] = wrench_channel(name, log[CONTACT_WRENCH])
    return {
        **joint_channels(name, robot, log),
        **poses,
        **{one: _held(name, one, at.tracks[one], tick) for one in sorted(at.tracks)},
    }


def _held(station: str, name: str, track: Track, tick: float) -> Channel:
    """Return the channel of a piecewise constant quantity with its value at a tick only."""
    return track_channel(station, name, Track([0], [track.value(tick)]), 0, 1)
