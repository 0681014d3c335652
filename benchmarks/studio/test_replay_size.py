"""Sizes of reports and packs, and the time to make them."""

from pathlib import Path
from typing import Any

import pytest
from measuring import Measure

from ropsim.workbench import open_project, pack_of
from ropsim.workbench.report import built_viewer

EXAMPLES = Path(__file__).parents[2] / "examples"
#: A report may have this much, and this much for each simulated minute [bytes].
PAGE, MINUTE = 1.7e6, 0.5e6
#: A pack may have this much for each simulated minute of the palletizing cell [bytes].
PACK_MINUTE = 0.37e6


@pytest.mark.parametrize("name", ["first_cell", "fig5", "palletizing"])
@pytest.mark.skipif(built_viewer() is None, reason="the pages of ropsim are not built")
def test_report_with_replay(benchmark: Any, name: str) -> None:
    project = open_project(EXAMPLES / name)
    recording = project.simulate()
    measure = Measure(benchmark)
    page, timing = measure(project.report(recording).html, rounds=2)
    size, minutes = len(page.encode()), recording.duration / 60.0
    measure.figure("report [MB]", size / 1e6)
    measure.figure("seconds", timing.median)
    assert size <= PAGE + MINUTE * minutes


def test_pack(benchmark: Any) -> None:
    project = open_project(EXAMPLES / "palletizing")
    recording = project.simulate()
    measure = Measure(benchmark)
    content, timing = measure(lambda: pack_of(project, recording), rounds=2)
    measure.figure("pack per minute [MB]", len(content) / recording.duration * 60.0 / 1e6)
    measure.figure("seconds", timing.median)
    assert len(content) * 60.0 / recording.duration <= PACK_MINUTE
