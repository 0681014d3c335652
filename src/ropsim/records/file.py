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
from ropsim.records.document import FORMAT, ChannelFacts, document, read_document
from ropsim.records.document import VERSION as KNOWN_VERSION
from ropsim.records.older import OLDER, UNTYPED, WITHOUT_PLACEMENTS, held, is_held, upgraded
from ropsim.records.plain_records import DocumentError
from ropsim.records.plain_values import NotPlainError
from ropsim.spatial import Array

HEADER = "header"
TIME = "time"
CHANNEL = "channel/"
CHANGES = "times/"
"""Before the name of a held channel: when it changed."""

FILE_LIMIT = 4 << 30
"""Largest file that is read [bytes]."""

HEADER_LIMIT = 256 << 20
"""Largest JSON header that is read [bytes]."""

_AGAIN = "make the recording again with `ropsim run … --record FILE`"


def write_recording(recording: Recording, path: str | Path) -> None:
    """Write a recording in one step; equal recordings have equal bytes.

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
    for name, channel in recording.channels.items():
        arrays[CHANNEL + name] = _little(channel.values)
        if channel.times is not None:
            arrays[CHANGES + name] = _little(channel.times)
    return npz.pack(arrays)


def read_recording(path: str | Path) -> Recording:
    """Return the recording in a file; its arrays are read-only.

    Raises:
        RecordingFileError: X870 to X875, the file cannot be read, is foreign, damaged, of an unknown format,
            inconsistent or too large.
    """
    path = Path(path)
    try:
        if path.stat().st_size > FILE_LIMIT:
            raise _error(TOO_LARGE, path, "more than 4 GiB", _AGAIN)
        content = read_bytes(path, FILE_LIMIT)
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
    older = plain["version"] in UNTYPED
    try:
        read_from = read_document(upgraded(plain) if older else plain)
        time = _floats(arrays, TIME)
        channels = {name: _channel(name, arrays, facts, time) for name, facts in read_from.channels.items()}
        if older:
            channels |= {name: held(one, time) for name, one in channels.items() if is_held(name)}
    except DocumentError as error:
        raise _error(CONTENT, path, str(error), _AGAIN) from error
    findings = read_from.findings
    if plain["version"] == WITHOUT_PLACEMENTS:
        findings = (*findings, NO_PLACEMENTS.at(None, f"recording `{path}` does not tell where parts were"))
    return Recording(
        time,
        channels,
        read_from.events,
        findings,
        read_from.duration,
        read_from.facts,
        read_from.placements,
        read_from.content,
    )


def _channel(name: str, arrays: dict[str, npz.AnyArray], facts: ChannelFacts, time: Array) -> Channel:
    values = _floats(arrays, CHANNEL + name)
    times = _floats(arrays, CHANGES + name) if facts.held else None
    columns, rows = len(facts.columns), time if times is None else times
    if rows.ndim != 1 or values.ndim not in {1, 2} or values.shape[0] != rows.shape[0]:
        raise DocumentError(f"channel `{name[:40]}` has shape {values.shape}, its times have {rows.shape}")
    if columns and (values.ndim != 2 or values.shape[1] != columns):
        raise DocumentError(f"channel `{name[:40]}` has shape {values.shape} and {columns} column names")
    if times is not None and (values.ndim != 1 or not len(times) or not bool((np.diff(times) > 0.0).all())):
        raise DocumentError(
            f"channel `{name[:40]}` is held, but its times are not ascending or of one column"
        )
    return Channel(values, facts.unit, facts.columns, facts.description, facts.group, facts.subject, times)


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
    if version not in (*OLDER, KNOWN_VERSION) or isinstance(version, bool):
        raise _error(
            VERSION, path, _unknown(version, plain), "read it with the ropsim that wrote it, or a newer one"
        )
    return plain


def _unknown(version: object, plain: dict[str, object]) -> str:
    """Return which version a recording has that cannot be read, and who wrote it."""
    facts = plain.get("facts")
    writer = facts.get("ropsim") if isinstance(facts, dict) else None
    by = f", written by ropsim {writer[:20]}" if isinstance(writer, str) and writer else ""
    known = ", ".join(map(str, OLDER))
    return f"format version {str(version)[:20]}{by}; this ropsim reads {known} and {KNOWN_VERSION}"


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
