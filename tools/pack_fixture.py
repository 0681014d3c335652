"""Write the pack that the page's own tests read: a kinematic run of the first cell, and what it must show.

python tools/pack_fixture.py           write the file
python tools/pack_fixture.py --check   compare keys only, not numbers; exit 1 and name those that differ

The expected figures come from the recording and the kinematics, not from the pack.
"""

import base64
import gzip
import json
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from ropsim.flow import Recording
from ropsim.kinematics import joint_frames
from ropsim.model import Cell
from ropsim.simulation import Fidelity, RunOptions
from ropsim.spatial import Pose
from ropsim.views import scene
from ropsim.workbench import open_project, pack_of

ROOT = Path(__file__).parent.parent
FIXTURE = ROOT / "frontend" / "src" / "run" / "fixtures" / "first_cell.json"
TIMES = (0.0, 0.4321, 1.25, 2.0, 3.3333)


def main(arguments: list[str]) -> int:
    """Write or check the fixture; return the exit code."""
    if not FIXTURE.is_file():
        print("no sources of pages here: an sdist carries them built")
        return 0
    wanted = document()
    if arguments != ["--check"]:
        FIXTURE.write_text(json.dumps(wanted, separators=(",", ":")) + "\n", encoding="utf-8")
        return 0
    there, run = set(keys(unpacked(json.loads(FIXTURE.read_text("utf-8"))))), set(keys(unpacked(wanted)))
    differing = [f"  lacks {key}" for key in sorted(run - there)]
    differing += [f"  has {key}" for key in sorted(there - run)]
    if differing:
        print(f"stale: {FIXTURE.name}; run python tools/pack_fixture.py", *differing, sep="\n")
    return int(bool(differing))


def document() -> dict[str, object]:
    """Return the content of the fixture.

    Raises:
        SystemExit: the example has no cell.
    """
    project = open_project(ROOT / "examples" / "first_cell")
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    cell = project.cell
    if cell is None:
        raise SystemExit("examples/first_cell has no cell")
    return {
        "scene": scene(cell),
        "pack": base64.b64encode(pack_of(project, recording)).decode("ascii"),
        "duration": recording.duration,
        "expected": [_expected(recording, cell, time) for time in TIMES],
    }


def unpacked(fixture: dict[str, object]) -> dict[str, object]:
    """Return the fixture with the header of its pack in place of the pack (docs/reference/pack.md)."""
    content = gzip.decompress(base64.b64decode(str(fixture["pack"])))
    end = 8 + int.from_bytes(content[4:8], "little")
    return {**fixture, "pack": json.loads(content[8:end])}


def keys(value: object, path: str = "") -> Iterator[str]:
    """Yield the paths of all keys in plain values, such as `stations.name` for one in a list of stations."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield f"{path}{key}"
            yield from keys(inner, f"{path}{key}.")
    elif isinstance(value, list | tuple):
        for inner in value:
            yield from keys(inner, path)


def _expected(recording: Recording, cell: Cell, time: float) -> dict[str, object]:
    rows = recording.channels["q"].values
    q = np.array([np.interp(time, recording.time, column) for column in rows.T])
    at = cell.first
    last = at.X_WB @ Pose.from_matrix(joint_frames(at.robot, q)[at.robot.n - 1])
    line = recording.rows("line")[np.searchsorted(recording.time, time)]
    return {"time": time, "q": q.tolist(), "last_link": list(last.as_tuple()), "line": float(line)}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
