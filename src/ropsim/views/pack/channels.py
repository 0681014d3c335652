"""Channels of a pack: every channel of the recording, sampled ones at the rate of the screen."""

import numpy as np

from ropsim.flow import Channel, Recording
from ropsim.spatial import Array
from ropsim.views.pack.columns import Body, Code, smooth, steps

QUATERNION_STEP = 2.0**-15

_STEPS = (
    ("rad/s", 1e-4),
    ("m/s", 1e-4),
    ("rad", 1e-6),
    ("m", 1e-6),
    *((unit, 1e-3) for unit in ("N", "A", "V", "W")),
)
"""Coarsest rounding by unit; `rad | m` counts as its first one. All are below the resolution of a plot."""


def packed_channels(recording: Recording, times: Array, body: Body) -> list[dict[str, object]]:
    """Return the entries of all channels, in the order of the recording.

    Args:
        recording: of the run.
        times: of the samples [s], shape (n,).
        body: gets the bytes of the columns.
    """
    return [
        {
            "name": name,
            "unit": channel.unit,
            "description": channel.description,
            "group": channel.group.value,
            "subject": channel.subject,
            "columns": _columns(name, channel, recording, times, body),
        }
        for name, channel in recording.channels.items()
    ]


def resampled(values: Array, recording: Recording, times: Array) -> Array:
    """Return columns (rows, k) at other times by linear interpolation, shape (n, k)."""
    return np.stack([np.interp(times, recording.time, column) for column in values.T], axis=1)


def continuous(quaternions: Array) -> Array:
    """Return unit quaternions (n, 4) with signs such that neighbours are near: q and -q turn alike."""
    turns = np.sum(quaternions[1:] * quaternions[:-1], axis=1) < 0.0
    signs = np.cumprod(np.concatenate([[1.0], np.where(turns, -1.0, 1.0)]))
    return np.asarray(quaternions * signs[:, None])


def _columns(
    name: str, channel: Channel, recording: Recording, times: Array, body: Body
) -> list[dict[str, object]]:
    if channel.times is not None:
        return [{"name": "", **_extremes(channel.values), "code": steps(channel.times, channel.values)}]
    values = channel.values.reshape(len(recording.time), -1)
    names = channel.columns or (("",) if values.shape[1] == 1 else tuple(map(str, range(values.shape[1]))))
    if name.endswith("_orientation") and values.shape[1] == 4:
        values = continuous(values)
    values = resampled(values, recording, times)
    codes: list[Code] = [smooth(column, _step(channel.unit), body) for column in values.T]
    return [
        {"name": label, **_extremes(column), "code": code}
        for label, column, code in zip(names, values.T, codes, strict=True)
    ]


def _step(unit: str) -> float:
    return next((step for start, step in _STEPS if unit.startswith(start)), QUATERNION_STEP)


def _extremes(values: Array) -> dict[str, float | None]:
    known = values[np.isfinite(values)]
    if not known.size:
        return {"min": None, "max": None}
    return {"min": float(known.min()), "max": float(known.max())}
