"""Recordings and recorded inputs."""

import io
import json
import zipfile
from dataclasses import replace
from pathlib import Path
from random import Random
from tempfile import mkdtemp

import numpy as np

from ropsim.flow import InputChange
from ropsim.records import InputsError, RecordingFileError, read_recording, recording_bytes
from ropsim.records.inputs import inputs_of, read_inputs, with_inputs
from ropsim.simulation import RunOptions
from support.fuzzing.mutation import BYTES, TEXT, changed_value, mutated
from support.fuzzing.target import Target
from support.recordings import pick_and_place, two_findings

_GIVEN = (InputChange(2.0, "start", 1.0), InputChange(2.5, "level", -0.25))
_INPUTS = [{"signal": one.signal, "time": one.time, "value": one.value} for one in _GIVEN]
_RUN = pick_and_place(1, 2.0, two_findings())
_RECORDING = recording_bytes(replace(_RUN, facts=replace(_RUN.facts, inputs=_GIVEN)))
_TEXT = json.dumps(_INPUTS).encode()
_WORK = Path(mkdtemp(prefix="ropsim-fuzz-"))
with zipfile.ZipFile(io.BytesIO(_RECORDING)) as _archive:
    _PARTS = {name: _archive.read(name) for name in _archive.namelist()}
_HEADER: object = json.loads(np.load(io.BytesIO(_PARTS["header.npy"])).tobytes())
_ENTRIES = ("header.npy", "time.npy")


def _recording(content: bytes) -> str:
    path = _WORK / "a.npz"
    path.write_bytes(content)
    try:
        found = read_recording(path)
    except RecordingFileError as error:
        return error.diagnostic.code
    try:
        inputs_of(found)
    except InputsError as error:
        return error.diagnostic.code
    return "read"


def _inputs(content: bytes) -> str:
    path = _WORK / "a.json"
    path.write_bytes(content)
    try:
        found = read_inputs(path)
    except InputsError as error:
        return error.diagnostic.code
    assert with_inputs(RunOptions(), found).inputs == found
    return "read"


def _made_recording(random: Random) -> bytes:
    if random.random() < 0.3:
        return mutated(random, _RECORDING, BYTES)
    entries = dict(_PARTS)
    for _ in range(random.choice((1, 1, 2))):
        name = random.choice(_ENTRIES if random.random() < 0.6 else sorted(entries))
        if name == "header.npy" and name in entries and random.random() < 0.8:
            entries[name] = _header(random)
        elif random.random() < 0.1:
            entries.pop(name, None)
        else:
            content = entries.get(name, b"")
            entries[name] = mutated(random, content[:128], (*BYTES, *TEXT)) + content[128:]
    return _zipped(random, entries)


def _header(random: Random) -> bytes:
    document = _HEADER
    for _ in range(random.choice((1, 1, 2, 3))):
        document = changed_value(random, document)
    text = json.dumps(document).encode()
    if random.random() < 0.1:
        text = mutated(random, text, TEXT)
    stream = io.BytesIO()
    np.save(stream, np.frombuffer(text, np.uint8))
    return stream.getvalue()


def _zipped(random: Random, entries: dict[str, bytes]) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, content in entries.items():
            packed = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            packed.compress_type = random.choice(
                (zipfile.ZIP_STORED, zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
            )
            archive.writestr(packed, content)
    return stream.getvalue()


def _made_inputs(random: Random) -> bytes:
    if random.random() < 0.4:
        return mutated(random, _TEXT, TEXT)
    document: object = _INPUTS
    for _ in range(random.choice((1, 1, 2, 3))):
        document = changed_value(random, document)
    return json.dumps(document).encode()


TARGETS = (Target("recording", _made_recording, _recording), Target("inputs", _made_inputs, _inputs))
