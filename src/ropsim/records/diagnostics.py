"""Diagnostics of recording files, X870 to X879."""

from ropsim.core import Category, RopsimError, Severity, define

UNREADABLE = define(
    "X870",
    "recording-file-not-readable",
    Severity.ERROR,
    "a recording file cannot be opened",
    """
The operating system refused to read the file: it does not exist, it is a folder, or you may not
read it.

Give the path that was written by `ropsim run … --record FILE`, and look at its permissions.
""",
)

FOREIGN = define(
    "X871",
    "not-a-recording-file",
    Severity.ERROR,
    "a file is not a recording of ropsim",
    """
A recording is an NPZ archive (a ZIP of NumPy arrays) with an entry `header.npy` that holds UTF-8
JSON. The file has no such archive or no such entry, so it was made by another program, or it is
only the beginning of a recording (a copy that broke off).

Copy the file again, or make it again with `ropsim run … --record FILE`. Its layout is described in
docs/reference/recording.md.
""",
)

DAMAGED = define(
    "X872",
    "damaged-recording-file",
    Severity.ERROR,
    "a recording file is damaged",
    """
The file is a recording, but a part of it does not agree with its checksum, has an impossible size
or cannot be unpacked. Nothing of it is used, because a figure that is only nearly right is worse
than none.

Copy the file again, or make it again with `ropsim run … --record FILE`.
""",
)

VERSION = define(
    "X873",
    "recording-version-unknown",
    Severity.ERROR,
    "a recording is of a format that this ropsim does not know",
    """
The header of the file names a version of the recording format that this ropsim does not know. The
finding tells which one that is, which ropsim wrote the file, and which versions this one reads: its
own, and the older ones.

Read it with the version of ropsim that wrote it, or install a newer one.
""",
)

CONTENT = define(
    "X874",
    "inconsistent-recording",
    Severity.ERROR,
    "the parts of a recording do not fit together",
    """
An array is missing, or one with samples has another number of rows than `time`; the changes of a
channel that holds its value are not in order of time; or the header lacks an entry, has one of the
wrong type or a word that is not known. Such a file was not written by ropsim, or it was changed
afterwards.

docs/reference/recording.md lists what a recording must hold.
""",
)

TOO_LARGE = define(
    "X875",
    "recording-too-large",
    Severity.ERROR,
    "a recording would fill the memory",
    """
The file announces more data than a recording may have (4 GiB in all, 256 MiB of header). A real run
of an hour at 1 kHz stays below that, so the file is damaged or was made to do harm.

Record at a lower rate, or record a shorter part of the run.
""",
)

NOT_PLAIN = define(
    "X876",
    "recording-value-not-plain",
    Severity.ERROR,
    "a recording holds a value that no file can keep",
    """
The data of the findings of a recording may hold texts, numbers, true, false, nothing, and lists and
mappings (with texts as keys) of those. Channels have names without control characters.

Turn the value into one of these before it goes into the recording.
""",
)

NOT_WRITTEN = define(
    "X877",
    "recording-file-not-written",
    Severity.ERROR,
    "a recording file cannot be written",
    """
The operating system refused to write: the folder may not be written, or the disk is full. An older
file of the same name is still whole.

Choose another path with `--record FILE`.
""",
    Category.USAGE,
)

INPUTS_UNREADABLE = define(
    "X878",
    "inputs-not-readable",
    Severity.ERROR,
    "recorded inputs cannot be read",
    """
`ropsim run PATH --inputs FILE` gives a run the inputs of an earlier live run. FILE is the recording of that
run (`.npz`), or a JSON list with times in seconds of simulated time, such as

```json
[
  {"signal": "start", "time": 1.5, "value": 1},
  {"override": 0.3, "time": 2.0},
  {"stop": true, "time": 9.0}
]
```

The file is missing, is no JSON, or an entry is none of these: a signal with a time and a value, an override
from 0 to 1 with a time, or one stop with a time.
""",
)

NO_PLACEMENTS = define(
    "X879",
    "recording-without-placements",
    Severity.HINT,
    "a recording of an older ropsim does not tell where parts were",
    """
Recordings of the first format hold channels, events and findings, but not which body each part hung on and
when. All of that is read; a view of such a recording shows every part where the cell file has it at the
start.

To see the parts move, make the recording again with `ropsim run … --record FILE`.
""",
)


class RecordingFileError(RopsimError):
    """A recording cannot be written or read; nothing half-written is left and nothing half-read returned."""


class InputsError(RopsimError):
    """Recorded inputs cannot be read; carries the finding."""
