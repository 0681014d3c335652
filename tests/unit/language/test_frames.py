"""Frames are lexical: what literals, named locations and `in` mean in each."""

from dataclasses import replace

import pytest

from ropsim.icr import run
from ropsim.language import Environment
from ropsim.spatial import Pose
from support.tasks import CELL, codes, compiled

TURNED = (0.5, 0.0, 0.2, 0.7071067811865476, 0.0, 0.0, 0.7071067811865475)
"""At (0.5, 0, 0.2), turned by 90° about Z."""
IN_FRAME = replace(CELL, frames={**CELL.frames, "table": TURNED})
ROUNDING = 1e-12
"""A few products of rotations in double precision."""


def base_positions(text: str, environment: Environment = IN_FRAME) -> list[tuple[float, float, float]]:
    """Return the positions of all moves in the base frame."""
    result = compiled(text, environment)
    assert result.icr is not None, result.diagnostics
    found = []
    for move in run(result.icr).moves:
        assert isinstance(move.target, Pose)
        x, y, z = (move.modal.X_BK @ move.target).as_tuple()[:3]
        found.append((x, y, z))
    return found


@pytest.mark.parametrize(
    "text",
    [
        "units mm\nmov (10, 20, 30) in table",
        "units mm\nset frame table\nmov (10, 20, 30)",
        "units mm\nwith frame table\nmov (10, 20, 30)\nendwith",
        "units mm\ntask t(q: loc)\nset frame table\nmov (10, 20, 30)\nendp\nt infeed",
        "units mm\nset frame pallet\nmov (10, 20, 30) in table",
        "units mm\nset frame table\nmov (0, 0, 0) offset (10, 20, 30)",
        "units mm\nmov (0, 0, 0) in table offset (10, 20, 30)",
        "units mm\nx = 10\nmov (x, 20, 30) in table",
    ],
)
def test_numbers_of_a_frame_reach_the_same_point(text: str) -> None:
    assert base_positions(text)[0] == pytest.approx((0.48, 0.01, 0.23), abs=ROUNDING)


def test_named_locations_do_not_move_with_the_work_frame() -> None:
    for text in ("mov infeed", "set frame table\nmov infeed", "with frame table\nmov infeed\nendwith"):
        assert base_positions(text)[0] == pytest.approx((0.4, 0.3, 0.1), abs=ROUNDING)


def test_the_environment_chooses_the_work_frame() -> None:
    inside = replace(IN_FRAME, frame="table")
    assert base_positions("units mm\nmov (10, 20, 30)", inside)[0] == pytest.approx((0.48, 0.01, 0.23))
    assert base_positions("mov infeed", inside)[0] == pytest.approx((0.4, 0.3, 0.1))
    result = compiled("mov infeed", inside)
    assert result.program is not None
    assert result.program.frame == "table"


def test_base_is_always_a_frame() -> None:
    inside = replace(IN_FRAME, frame="table")
    assert base_positions("units mm\nmov (10, 20, 30) in base", inside)[0] == pytest.approx(
        (0.01, 0.02, 0.03)
    )


def test_a_frame_set_in_a_task_ends_with_it() -> None:
    text = "units mm\ntask t\nset frame table\nmov (10, 20, 30)\nendp\nt\nmov (10, 20, 30)"
    assert base_positions(text)[1] == pytest.approx((0.01, 0.02, 0.03), abs=ROUNDING)


def test_a_component_is_seen_and_set_in_the_frame_in_force() -> None:
    change = "with frame table\nq.x = q.x + 5\nendwith"
    text = f"units mm\nq = (10, 20, 30) in table\n{change}\nmov q"
    assert base_positions(text)[0] == pytest.approx((0.48, 0.015, 0.23), abs=ROUNDING)


def test_above_goes_back_along_the_approach_direction() -> None:
    assert base_positions("units mm\nmov infeed above 50")[0] == pytest.approx((0.4, 0.3, 0.15), abs=ROUNDING)


def test_declared_frames_stand_on_others() -> None:
    text = "units mm\nframe shelf = (0, 0, 100) in table\nmov (10, 20, 30) in shelf"
    assert base_positions(text)[0] == pytest.approx((0.48, 0.01, 0.33), abs=ROUNDING)


def test_an_unknown_frame_is_named_with_the_nearest() -> None:
    found = compiled("mov infeed in tabel", IN_FRAME).diagnostics
    assert [(d.code, d.hint) for d in found] == [("N203", "did you mean `table`?")]
    assert codes("set frame nowhere\nmov infeed", IN_FRAME) == ["N203"]
