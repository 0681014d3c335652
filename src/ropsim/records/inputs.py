"""Recorded inputs of a live run: from a recording or a file, to be given to a run again."""

import json
import math
import stat
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import read_bytes
from ropsim.flow import InputChange, Recording
from ropsim.records.diagnostics import INPUTS_UNREADABLE, InputsError
from ropsim.records.file import read_recording

if TYPE_CHECKING:
    from ropsim.simulation import RunOptions

LARGEST = 5_000_000
"""Largest JSON text of inputs that is read [bytes]."""

_FORM = 'a list of `{"signal": "NAME", "time": SECONDS, "value": NUMBER}`'


def inputs_of(recording: Recording) -> tuple[InputChange, ...]:
    """Return the inputs that a run was given.

    Raises:
        InputsError: X878, a time or value in the recording is not finite.
    """
    for k, one in enumerate(recording.facts.inputs, start=1):
        for name, number in (("time", one.time), ("value", one.value)):
            if not math.isfinite(number):
                raise _unreadable(f"facts of the recording, entry {k}", f"`{name}` must be a finite number")
    return recording.facts.inputs


def with_inputs(options: "RunOptions", inputs: tuple[InputChange, ...]) -> "RunOptions":
    """Return options of a run that takes recorded inputs again, and lasts longer for them.

    A live run waits for a key as long as it takes; its inputs must find the program still waiting.
    """
    later = max((one.time for one in inputs), default=0.0)
    return replace(
        options,
        inputs=inputs,
        longest=options.longest + later,
        longest_wait=options.longest_wait + later,
    )


def inputs_from_plain(plain: object, source: str) -> tuple[InputChange, ...]:
    """Return the inputs that plain values describe.

    Args:
        plain: list of mappings of `signal`, `time` [s] and `value`.
        source: where they are from, for messages.

    Raises:
        InputsError: X878, they are not of that form.
    """
    if not isinstance(plain, (list, tuple)):
        raise _unreadable(source, f"found a `{type(plain).__name__}`, needed is {_FORM}")
    return tuple(_input(entry, f"{source}, entry {k}") for k, entry in enumerate(plain, start=1))


def read_inputs(path: str | Path) -> tuple[InputChange, ...]:
    """Return the inputs in a JSON file or in the recording (`.npz`) of a live run.

    Raises:
        InputsError: X878, the file cannot be read or holds something else.
        RecordingFileError: X870 to X875, the recording is damaged or foreign.
    """
    path = Path(path)
    if path.suffix == ".npz":
        return inputs_of(read_recording(path))
    try:
        facts = path.stat()
        if not stat.S_ISREG(facts.st_mode):
            raise _unreadable(str(path), "it is no ordinary file")
        if facts.st_size > LARGEST:
            raise _unreadable(str(path), f"it is larger than {LARGEST / 1e6:.0f} MB")
        text = read_bytes(path).decode("utf-8-sig")
    except OSError as error:
        raise _unreadable(str(path), (error.strerror or type(error).__name__).lower()) from error
    except UnicodeDecodeError as error:
        raise _unreadable(str(path), "it is no UTF-8 text") from error
    try:
        plain = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise _unreadable(str(path), f"it is no JSON text: {error}"[:200]) from error
    return inputs_from_plain(plain, str(path))


def _input(entry: object, source: str) -> InputChange:
    if not isinstance(entry, dict):
        raise _unreadable(source, f"found a `{type(entry).__name__}`, needed is {_FORM}")
    signal = entry.get("signal")
    if not isinstance(signal, str):
        raise _unreadable(source, "`signal` must be the name of an input")
    from ropsim.simulation import InputChange

    return InputChange(_number(entry, "time", source), signal, _number(entry, "value", source))


def _number(entry: dict[object, object], key: str, source: str) -> float:
    value = entry.get(key)
    if isinstance(value, bool) and key == "value":
        return float(value)
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise _unreadable(source, f"`{key}` must be a number")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise _unreadable(source, f"`{key}` must be a finite number")
    return number


def _unreadable(source: str, reason: str) -> InputsError:
    hint = "record the inputs again, or correct the file; docs/reference/recording.md tells its form"
    return InputsError(INPUTS_UNREADABLE.at(None, f"inputs from `{source}`: {reason}", hint=hint))
