"""Write the pack that the page's own tests read: a kinematic run of the first cell, and what it must show.

python tools/pack_fixture.py

The expected figures come from the recording and the kinematics, not from the pack.
"""

import base64
import json
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


def main() -> None:
    """Write the fixture."""
    project = open_project(ROOT / "examples" / "first_cell")
    recording = project.simulate(None, RunOptions(Fidelity.KINEMATIC))
    cell = project.cell
    if cell is None:
        raise SystemExit("examples/first_cell has no cell")
    document = {
        "scene": scene(cell),
        "pack": base64.b64encode(pack_of(project, recording)).decode("ascii"),
        "duration": recording.duration,
        "expected": [_expected(recording, cell, time) for time in TIMES],
    }
    FIXTURE.parent.mkdir(exist_ok=True)
    FIXTURE.write_text(json.dumps(document, separators=(",", ":")) + "\n", encoding="utf-8")


def _expected(recording: Recording, cell: Cell, time: float) -> dict[str, object]:
    rows = recording.channels["q"].values
    q = np.array([np.interp(time, recording.time, column) for column in rows.T])
    at = cell.first
    last = at.X_WB @ Pose.from_matrix(joint_frames(at.robot, q)[at.robot.n - 1])
    line = recording.rows("line")[np.searchsorted(recording.time, time)]
    return {"time": time, "q": q.tolist(), "last_link": list(last.as_tuple()), "line": float(line)}


if __name__ == "__main__":
    main()
