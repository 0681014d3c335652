"""Recordings and recorded inputs."""

import io
import json
import zipfile
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from tempfile import mkdtemp

import numpy as np

from ropsim.flow import InputChange, Interventions, OverrideChange, Recording
from ropsim.records import (
    InputsError,
    RecordingFileError,
    inputs_of,
    inputs_text,
    read_inputs,
    read_recording,
    recording_bytes,
    with_inputs,
)
from ropsim.records.plain_inputs import inputs_from_plain, plain_from_inputs
from ropsim.simulation import RunOptions
from ropsim.views import summarize
from support.fuzzing.mutation import BYTES, TEXT, changed_value, mutated
from support.fuzzing.target import Target
from support.older_recordings import version_2
from support.recordings import pick_and_place, two_findings

_GIVEN = (InputChange(2.0, "start", 1.0), InputChange(2.5, "level", -0.25))
_OVERRIDES, _STOPPED = (OverrideChange(2.2, 0.5), OverrideChange(2.4, 0.0)), 2.75
_INPUTS = plain_from_inputs(Interventions(_GIVEN, _OVERRIDES, _STOPPED))
_RUN = pick_and_place(1, 2.0, two_findings())
_FACTS = replace(_RUN.facts, inputs=_GIVEN, overrides=_OVERRIDES, stopped=_STOPPED)
_RECORDING = recording_bytes(replace(_RUN, facts=_FACTS))
_TEXT = json.dumps(_INPUTS).encode()
_WORK = Path(mkdtemp(prefix="ropsim-fuzz-"))
_ENTRIES = ("header.npy", "time.npy")


@dataclass(frozen=True, slots=True)
class _Seed:
    """A whole recording: the file, its entries, and the document in one of them."""

    content: bytes
    parts: dict[str, bytes]
    document: object

    @classmethod
    def of(cls, content: bytes) -> "_Seed":
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            parts = {name: archive.read(name) for name in archive.namelist()}
        return cls(content, parts, json.loads(np.load(io.BytesIO(parts["header.npy"])).tobytes()))


_SEEDS = (_Seed.of(_RECORDING), _Seed.of(version_2()))


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
    summarize(found)
    again = read_again(found)
    # orientations that were no unit quaternions are made such, and rounded once more the next time
    assert replace(again, placements=()) == replace(found, placements=())
    return "read"


def read_again(recording: Recording) -> Recording:
    """Return a recording after it was written and read."""
    path = _WORK / "b.npz"
    path.write_bytes(recording_bytes(recording))
    return read_recording(path)


def _inputs(content: bytes) -> str:
    path = _WORK / "a.json"
    path.write_bytes(content)
    try:
        found = read_inputs(path)
    except InputsError as error:
        return error.diagnostic.code
    assert inputs_from_plain(json.loads(inputs_text(found)), "text") == in_order(found)
    try:
        assert with_inputs(RunOptions(), found).inputs == found.inputs
    except InputsError:
        assert found.overrides or found.stopped is not None
    return "read"


def in_order(given: Interventions) -> Interventions:
    """Return the same in order of time, as it is written."""
    return Interventions(
        tuple(sorted(given.inputs, key=lambda one: one.time)),
        tuple(sorted(given.overrides, key=lambda one: one.time)),
        given.stopped,
    )


def _made_recording(random: Random) -> bytes:
    seed = random.choice(_SEEDS)
    if random.random() < 0.3:
        return mutated(random, seed.content, BYTES)
    entries = dict(seed.parts)
    for _ in range(random.choice((1, 1, 2))):
        name = random.choice(_ENTRIES if random.random() < 0.6 else sorted(entries))
        if name == "header.npy" and name in entries and random.random() < 0.8:
            entries[name] = _header(random, seed.document)
        elif random.random() < 0.1:
            entries.pop(name, None)
        else:
            content = entries.get(name, b"")
            entries[name] = mutated(random, content[:128], (*BYTES, *TEXT)) + content[128:]
    return _zipped(random, entries)


def _header(random: Random, document: object) -> bytes:
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
