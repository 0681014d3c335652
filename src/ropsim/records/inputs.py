"""Interventions of a live run: read from a recording or a file, for another run, and as text."""

import json
import stat
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import read_bytes
from ropsim.flow import SLOWEST, Interventions, OverrideChange, Recording, in_time
from ropsim.records.file import read_recording
from ropsim.records.plain_inputs import finite, inputs_from_plain, plain_from_inputs, share, unreadable

if TYPE_CHECKING:
    from ropsim.simulation import RunOptions

LARGEST = 5_000_000
"""Largest JSON text of inputs that is read [bytes]."""

LONGEST = 4 * 3600.0
"""Time that is simulated at most, however late the last input comes [s]."""


def inputs_of(recording: Recording) -> Interventions:
    """Return the interventions of a run.

    Raises:
        InputsError: X878, a time or value in the recording is none.
    """
    given = recording.facts.interventions
    source = "facts of the recording"
    for k, change in enumerate(given.inputs, start=1):
        finite(change.time, "time", f"{source}, entry {k} of the inputs")
        finite(change.value, "value", f"{source}, entry {k} of the inputs")
    for k, one in enumerate(given.overrides, start=1):
        finite(one.time, "time", f"{source}, entry {k} of the overrides")
        share(one.value, f"{source}, entry {k} of the overrides")
    if given.stopped is not None:
        finite(given.stopped, "stopped", source)
    return given


def with_inputs(options: "RunOptions", given: Interventions) -> "RunOptions":
    """Return options of a run that is given the same as a live run was, and lasts longer for it.

    A live run waits for a key, and at a low override for a move, as long as needed; its interventions must
    meet the program at the same place again.
    """
    times = [*(one.time for one in given.inputs), *(one.time for one in given.overrides)]
    later = max([*times, given.stopped or 0.0])
    last = in_time((OverrideChange(0.0, 1.0), *given.overrides))[-1].value
    pace = last if last >= SLOWEST else 1.0
    return replace(
        options,
        inputs=given.inputs,
        overrides=given.overrides,
        stopped=given.stopped,
        longest=min(options.longest / pace + later, LONGEST),
        longest_wait=min(options.longest_wait / pace + later, LONGEST),
    )


def inputs_text(given: Interventions) -> bytes:
    """Return the interventions of a run as a JSON list in order of time, one per line, for `read_inputs`."""
    entries = [json.dumps(entry, ensure_ascii=False) for entry in plain_from_inputs(given)]
    inside = ",\n".join(f"  {entry}" for entry in entries)
    return f"[\n{inside}\n]\n".encode() if entries else b"[]\n"


def read_inputs(path: str | Path) -> Interventions:
    """Return the interventions of a JSON file, or of the recording (`.npz`) of a live run.

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
            raise unreadable(str(path), "it is no ordinary file")
        if facts.st_size > LARGEST:
            raise unreadable(str(path), f"it is larger than {LARGEST / 1e6:.0f} MB")
        text = read_bytes(path, LARGEST).decode("utf-8-sig")
    except OSError as error:
        raise unreadable(str(path), (error.strerror or type(error).__name__).lower()) from error
    except UnicodeDecodeError as error:
        raise unreadable(str(path), "it is no UTF-8 text") from error
    try:
        plain = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise unreadable(str(path), f"it is no JSON text: {error}"[:200]) from error
    return inputs_from_plain(plain, str(path))
