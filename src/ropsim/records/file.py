"""Recordings as files: NPZ arrays and a JSON header; docs/reference/recording.md describes the layout."""

import json
from pathlib import Path

import numpy as np

from ropsim.core import Kind, read_bytes, replace_file
from ropsim.flow import Channel, Recording
from ropsim.records import npz
from ropsim.records.diagnostics import (
    CONTENT,
    DAMAGED,
    FOREIGN,
    NO_PLACEMENTS,
    NOT_PLAIN,
    NOT_WRITTEN,
    TOO_LARGE,
    UNREADABLE,
    VERSION,
    RecordingFileError,
)
from ropsim.records.document import FORMAT, ChannelFacts, DocumentError, document, read_document
from ropsim.records.document import VERSION as KNOWN_VERSION
from ropsim.records.plain_values import NotPlainError
from ropsim.spatial import Array

HEADER = "header"
TIME = "time"
CHANNEL = "channel/"

_WITHOUT_PLACEMENTS = 1
"""Version of the first format."""

FILE_LIMIT = 4 << 30
"""Largest file that is read [bytes]."""

HEADER_LIMIT = 256 << 20
"""Largest JSON header that is read [bytes]."""

_AGAIN = "make the recording again with `ropsim run … --record FILE`"


def write_recording(recording: Recording, path: str | Path) -> None:
    """Write a recording in one step; equal recordings give equal bytes.

    Raises:
        RecordingFileError: X876, it holds a value that no file can keep; X877, the disk refuses.
    """
    content = recording_bytes(recording)
    try:
        replace_file(Path(path), content)
    except OSError as error:
        raise _error(NOT_WRITTEN, Path(path), _reason(error), "choose another path") from error


def recording_bytes(recording: Recording) -> bytes:
    """Return the content of the file of a recording.

    Raises:
        RecordingFileError: X876, it holds a value that no file can keep.
    """
    for name in recording.channels:
        if not name.isprintable() or "\\" in name:
            raise _not_plain(f"the name of channel {name!r} has control characters")
    try:
        text = json.dumps(document(recording), allow_nan=False, separators=(",", ":"))
    except NotPlainError as error:
        raise _not_plain(str(error)) from error
    arrays: dict[str, npz.AnyArray] = {
        HEADER: np.frombuffer(text.encode("ascii"), np.uint8),
        TIME: _little(recording.time),
    }
    arrays.update({CHANNEL + name: _little(channel.values) for name, channel in recording.channels.items()})
    return npz.pack(arrays)


def read_recording(path: str | Path) -> Recording:
    """Return the recording in a file; its arrays are read-only.

    Raises:
        RecordingFileError: X870 to X875, the file cannot be read, is foreign, damaged, of a newer format,
            inconsistent or too large.
    """
    path = Path(path)
    try:
        if path.stat().st_size > FILE_LIMIT:
            raise _error(TOO_LARGE, path, "more than 4 GiB", _AGAIN)
        content = read_bytes(path)
    except OSError as error:
        raise _error(UNREADABLE, path, _reason(error), "look at the path and its permissions") from error
    try:
        arrays = npz.unpack(content)
    except npz.ForeignFileError as error:
        raise _error(FOREIGN, path, str(error), _AGAIN) from error
    except npz.TooLargeError as error:
        raise _error(TOO_LARGE, path, "more than 4 GiB unpacked", _AGAIN) from error
    except npz.DamagedFileError as error:
        raise _error(DAMAGED, path, str(error), _AGAIN) from error
    return _recording(arrays, path)


def _recording(arrays: dict[str, npz.AnyArray], path: Path) -> Recording:
    plain = _header(arrays, path)
    try:
        facts = read_document(plain)
        time = _floats(arrays, TIME)
        channels = {
            name: _channel(name, _floats(arrays, CHANNEL + name), channel, time)
            for name, channel in facts.channels.items()
        }
    except DocumentError as error:
        raise _error(CONTENT, path, str(error), _AGAIN) from error
    findings = facts.findings
    if plain["version"] == _WITHOUT_PLACEMENTS:
        findings = (*findings, NO_PLACEMENTS.at(None, f"recording `{path}` does not tell where parts were"))
    return Recording(time, channels, facts.events, findings, facts.duration, facts.header, facts.placements)


def _channel(name: str, values: Array, facts: ChannelFacts, time: Array) -> Channel:
    columns = len(facts.columns)
    if time.ndim != 1 or values.ndim not in {1, 2} or values.shape[0] != time.shape[0]:
        raise DocumentError(f"channel `{name[:40]}` has shape {values.shape}, `time` has {time.shape}")
    if columns and (values.ndim != 2 or values.shape[1] != columns):
        raise DocumentError(f"channel `{name[:40]}` has shape {values.shape} and {columns} column names")
    return Channel(values, facts.unit, facts.columns, facts.description)


def _header(arrays: dict[str, npz.AnyArray], path: Path) -> dict[str, object]:
    raw = arrays.get(HEADER)
    if raw is None or raw.dtype != np.uint8:
        raise _error(FOREIGN, path, "it has no entry `header.npy` with text", _AGAIN)
    if raw.size > HEADER_LIMIT:
        raise _error(TOO_LARGE, path, "more than 256 MiB of header", _AGAIN)
    try:
        plain = json.loads(raw.tobytes().decode("utf-8"))
    except (ValueError, RecursionError) as error:
        raise _error(DAMAGED, path, "the header is no JSON text", _AGAIN) from error
    if not isinstance(plain, dict) or plain.get("format") != FORMAT:
        raise _error(FOREIGN, path, f"its header is not one of format `{FORMAT}`", _AGAIN)
    version = plain.get("version")
    if version not in (_WITHOUT_PLACEMENTS, KNOWN_VERSION) or isinstance(version, bool):
        found = f"format version {str(version)[:20]}, known are {_WITHOUT_PLACEMENTS} and {KNOWN_VERSION}"
        raise _error(VERSION, path, found, "update ropsim")
    return plain


def _floats(arrays: dict[str, npz.AnyArray], name: str) -> Array:
    values = arrays.get(name)
    if values is None or values.dtype != np.float64:
        raise DocumentError(f"array `{name[:60]}` is missing or not of float64")
    return np.asarray(values, dtype=np.float64)


def _little(values: Array) -> Array:
    return np.asarray(values, dtype="<f8")


def _reason(error: OSError) -> str:
    return (error.strerror or type(error).__name__).lower()


def _error(kind: Kind, path: Path, reason: str, hint: str) -> RecordingFileError:
    return RecordingFileError(kind.at(None, f"recording `{path}`: {reason}", hint=hint))


def _not_plain(reason: str) -> RecordingFileError:
    return RecordingFileError(
        NOT_PLAIN.at(None, f"the recording cannot be written: {reason}", hint="use plain values")
    )
