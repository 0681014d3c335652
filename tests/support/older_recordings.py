"""A run as ropsim wrote it in version 2 of its recordings: kept as text, put together as a file."""

import json
from typing import Any

import numpy as np

from ropsim.records import npz
from support.golden import GOLDEN

KEPT: dict[str, Any] = json.loads((GOLDEN / "recordings" / "version_2.json").read_text("utf-8"))
"""The document of the run, and those of its arrays that hold their values; the others are zeros here."""


def version_2(**changes: object) -> bytes:
    """Return the file of the run, with some entries of its document changed."""
    document, rows = KEPT["document"] | changes, len(KEPT["arrays"]["time"])
    arrays: dict[str, npz.AnyArray] = {"header": np.frombuffer(json.dumps(document).encode(), np.uint8)}
    for name, about in KEPT["document"]["channels"].items():
        width = len(about["columns"])
        known = KEPT["arrays"].get(f"channel/{name}")
        arrays[f"channel/{name}"] = np.array(known) if known else np.zeros((rows, width) if width else rows)
    arrays["time"] = np.array(KEPT["arrays"]["time"])
    return npz.pack(arrays)
