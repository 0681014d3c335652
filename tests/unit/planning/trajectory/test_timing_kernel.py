"""When runs begin and end: the compiled loop beside what time laws tell one by one."""

from itertools import pairwise

import numpy as np
import pytest

from ropsim.motion import Interval, PiecewiseLaw, plan_time_law
from ropsim.planning.testing import lay_sections

ROUNDING = 1e-12


def laws(random: np.random.Generator, count: int) -> list[PiecewiseLaw]:
    rows = random.uniform(0.2, 2.0, (count, 3, 4))
    return [
        plan_time_law([Interval(*row.tolist()) for row in law[: 1 + k % 3]]) for k, law in enumerate(rows)
    ]


@pytest.mark.parametrize("seed", range(5))
def test_runs_overlap_as_long_as_the_shorter_of_both_parts_beside_a_corner(seed: int) -> None:
    random = np.random.default_rng(seed)
    each = laws(random, 9)
    asked = np.array([(law.segments.shape[1], len(law.ends), *random.uniform(0.0, 0.3, 2)) for law in each])
    asked[3, 2] = np.nan
    segments, ends = (
        np.concatenate([law.segments for law in each], 1),
        np.concatenate([law.ends for law in each]),
    )
    runs, times = np.empty((9, 7)), np.empty((9, 3))
    lay_sections(segments, ends, asked, runs, times)
    assert times.tolist() == runs[:, (0, 6, 1)].tolist()
    assert times[0, :2].tolist() == [0.0, 0.0]
    assert runs[:, 2].tolist() == [law.duration for law in each]
    assert runs[:, 4].tolist() == asked[:, 0].tolist()
    assert np.diff(runs[:, 3]).tolist() == asked[:-1, 0].tolist()
    assert np.diff(runs[:, 5]).tolist() == asked[:-1, 1].tolist()
    assert times[:, 2] - times[:, 0] == pytest.approx(runs[:, 2], rel=ROUNDING)
    assert times[1:, 0] == pytest.approx(times[:-1, 2] - times[1:, 1], rel=ROUNDING)
    assert times[4, 1] == 0.0
    for number, (before, behind) in enumerate(pairwise(each)):
        if number != 3:
            left = before.duration - before.time_of(len(before.ends) - 1, asked[number, 2])
            entered = behind.time_of(0, asked[number, 3])
            assert times[number + 1, 1] == pytest.approx(min(left, entered), rel=ROUNDING)
