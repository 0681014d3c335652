"""Reading packs back, written apart from the writer: one number after the other, as the page does it."""

import gzip
import json
import struct
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ropsim.spatial import Array, Pose


@dataclass(frozen=True, slots=True)
class ReadPack:
    """A pack as a page sees it: plain header, bytes of the columns; ways of bodies are read once."""

    header: dict[str, Any]
    body: bytes
    _ways: dict[str, list[Array]] = field(default_factory=dict, init=False, repr=False, compare=False)

    @property
    def times(self) -> Array:
        """Return the times of the samples [s]."""
        count, rate = int(self.header["count"]), float(self.header["rate"])
        return np.minimum(np.arange(count) / rate, float(self.header["duration"]))

    def column(self, channel: str, column: int = 0) -> Array:
        """Return a column of a channel at the samples; NaN in gaps."""
        entry = next(one for one in self.header["channels"] if one["name"] == channel)
        return values_of(entry["columns"][column]["code"], self.body, self.times)

    def pose(self, name: str, time: float) -> Pose:
        """Return the pose X_W… of a link or part at a time."""
        body = self._body(name)
        if body["track"] == "poses":
            times = self.times
            if name not in self._ways:
                self._ways[name] = [values_of(code, self.body, times) for code in body["columns"]]
            at = [np.interp(time, times, values) for values in self._ways[name]]
            return Pose(np.array(at[:3]), np.array(at[3:]))
        one = self._placement(body, time)
        pose = Pose.from_tuple(tuple(one["pose"]))
        return (
            pose
            if one["parent"] < 0
            else self.pose(self.header["bodies"][one["parent"]]["name"], time) @ pose
        )

    def visible(self, name: str, time: float) -> bool:
        """Return whether a part is to be seen at a time."""
        return bool(self._placement(self._body(name), time)["visible"])

    def _body(self, name: str) -> dict[str, Any]:
        bodies: list[dict[str, Any]] = self.header["bodies"]
        return next(one for one in bodies if one["name"] == name)

    def _placement(self, body: dict[str, Any], time: float) -> dict[str, Any]:
        placements: list[dict[str, Any]] = body["placements"]
        return [one for one in placements if one["time"] <= time][-1]


def read_pack(content: bytes) -> ReadPack:
    """Return the pack in a file."""
    raw = gzip.decompress(content)
    assert raw[:4] == b"RPK1"
    (length,) = struct.unpack("<I", raw[4:8])
    return ReadPack(json.loads(raw[8 : 8 + length]), raw[8 + length :])


def values_of(code: dict[str, Any], body: bytes, times: Array) -> Array:
    """Return a column at some times."""
    none = float("nan")
    if code["kind"] == "constant":
        return np.full(len(times), none if code["value"] is None else code["value"])
    if code["kind"] == "steps":
        held = [none if value is None else value for value in code["values"]]
        index = np.searchsorted(code["times"], times, side="right") - 1
        return np.array(held)[np.maximum(index, 0)]
    values, slope, whole = [], 0, 0
    for number in _varints(body[code["offset"] : code["offset"] + code["length"]]):
        slope += number // 2 if number % 2 == 0 else -(number + 1) // 2
        whole += slope
        values.append(whole * code["step"])
    result = np.array(values)
    for first, end in code["gaps"]:
        result[first:end] = none
    return result


def _varints(content: bytes) -> list[int]:
    numbers, number, shift = [], 0, 0
    for byte in content:
        number |= (byte & 0x7F) << shift
        shift += 7
        if byte < 0x80:
            numbers.append(number)
            number, shift = 0, 0
    assert shift == 0, "the last number is cut off"
    return numbers
