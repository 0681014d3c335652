"""Frames are lexical: what literals, named locations and `in` mean in each."""

from dataclasses import replace

import pytest

from ropsim.icr import run
from ropsim.language import Environment
from ropsim.spatial import Pose, quaternion
from support.outcomes import outcome
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


LITERALS = (
    "(10, 20, 30)",
    "(10, 20, 30, 80, 5)",
    "(10, 20, 30, 5, 6, 7)",
    "(10, 20, 30; pitch 70)",
    "(10, 20, 30; like infeed)",
    "(10, 20, 30; down, rz 30)",
    "(10, 20, 30, 80, 5) above 4",
    "(10, 20, 30; like infeed) rel (1, 2, 3; rx 10)",
    "(10, 20, 30; like infeed) offset (1, 2, 3)",
    "(10, 20, 30, 80, 5) offset (1, 2, 3) above 4",
)
OF_VARIABLES = ("(q.x, q.y, 30; like q)", "(q.x + 5, 20, 30, 80, 5)", "(10, d, 30; rz q.rz)")
WAYS = (
    "lin {} in F",
    "a = {} in F\nlin a",
    "with frame F\nlin {}\nendwith",
    "set frame F\nlin {}",
    "set frame F\nwith frame base\nlin {} in F\nendwith",
    "with frame F\na = {}\nendwith\nlin a",
    "task Go\nset frame F\nlin {}\nendp\nGo",
    "task There -> loc\nreturn {} in F\nendp\na = There()\nlin a",
)
DECLARED = (
    "loc a = {} in F\nlin a",
    "set frame F\nloc a = {}\nlin a",
    "set frame base\nset frame F\nloc a = {}\nset frame base\nlin a",
    "const a = {} in F\nlin a",
    "set frame F\nconst a = {}\nlin a",
    "var a: loc = {} in F\nlin a",
    "set frame F\nvar a: loc = {}\nlin a",
    "pattern s = grid 1 from {} in F step (1, 0, 0)\nfor each a in s\nlin a\nendf",
    "set frame F\npattern s = grid 1 from {} step (1, 0, 0)\nfor each a in s\nlin a\nendf",
)


@pytest.mark.parametrize("work", ["", "table"])
@pytest.mark.parametrize("frame", ["tilted", "base"])
@pytest.mark.parametrize("written", [*LITERALS, *OF_VARIABLES])
def test_a_location_in_numbers_is_read_alike_however_its_frame_is_named(
    written: str, frame: str, work: str
) -> None:
    """By `in`, `with` or `set`, in a move, a task, a variable or a declaration, in any work frame."""
    head = "program p\nunits mm, deg, s\nframe tilted = (-40, 30, 10; rx 30, rz 25) in pallet\n"
    start = "var q: loc\nvar d: length = 7 mm\nq = infeed rel (0, 0, 0; rz 12)\nlin infeed\n"
    ways = WAYS if written in OF_VARIABLES else (*WAYS, *DECLARED)
    inside = replace(IN_FRAME, frame=work)
    found = {}
    for way in ways:
        text = f"{head}{start}{way.format(written)}".replace(" F", f" {frame}")
        moves = outcome(text, environment=inside).moves
        target = moves[-1].target
        assert isinstance(target, Pose)
        found[way] = (moves[-1].modal.X_BK @ target).matrix()
    first = found[ways[0]]
    assert [way for way, one in found.items() if abs(one - first).max() > ROUNDING] == []


def test_five_numbers_count_from_the_base_frame_wherever_they_are_read() -> None:
    """The azimuth is that of the point in the base frame, and so is that of the approach direction."""
    for text in ("lin (100, 0, 0, 0, 0) in table", "with frame table\nlin (100, 0, 0, 0, 0)\nendwith"):
        (move,) = outcome(f"program p\nunits mm\n{text}", environment=IN_FRAME).moves
        assert isinstance(move.target, Pose)
        x, y, _, *turn = (move.modal.X_BK @ move.target).as_tuple()
        w, a, b, c = turn
        approach = quaternion.rotate((w, a, b, c), (0.0, 0.0, 1.0))
        assert (x, y) == pytest.approx((0.5, 0.1), abs=ROUNDING)
        assert approach == pytest.approx((0.5 / 0.26**0.5, 0.1 / 0.26**0.5, 0.0), abs=ROUNDING)


def test_like_takes_the_orientation_of_its_model_in_the_room() -> None:
    for text in ("lin (1, 2, 3; like infeed) in table", "set frame table\nlin (1, 2, 3; like infeed)"):
        move = outcome(f"program p\nunits mm\nopen\n{text}", environment=IN_FRAME).moves[-1]
        assert isinstance(move.target, Pose)
        assert (move.modal.X_BK @ move.target).as_tuple()[3:] == pytest.approx(CELL.locations["infeed"][3:7])


@pytest.mark.parametrize("frame", ["", "pallet", "table"])
def test_five_numbers_of_a_step_and_a_tool_count_from_the_axes_of_these(frame: str) -> None:
    """They are no places in the room, so the frame of the lines around them has no say."""
    inside = replace(IN_FRAME, frame=frame)
    text = "program p\nunits mm\ntool t = (10, 0, 100, 90, 0)\nopen\n{}lin infeed rel (10, 0, 5, 0, 0) tool t"
    found = []
    for setting in ("", "set frame table\n"):
        (move,) = outcome(text.format(setting), environment=inside).moves
        assert isinstance(move.target, Pose)
        assert move.modal.X_MT is not None
        found += [move.modal.X_MT.matrix(), (move.modal.X_BK @ move.target).matrix()]
    X_MT, X_BT = found[:2]
    assert abs(found[2] - X_MT).max() < ROUNDING
    assert abs(found[3] - X_BT).max() < ROUNDING
    assert X_MT[:3, 2] == pytest.approx((0.0, 0.0, -1.0), abs=ROUNDING)
    assert X_BT[:3, 2] == pytest.approx((1.0, 0.0, 0.0), abs=ROUNDING)


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


ABOUT_Z = "units mm\nframe turned = (100, 0, 0; rz 90)\n"
"""Its x axis is y of the base frame."""
NAMED = ABOUT_Z + "loc a = (10, 0, 0) in turned\nvar g: loc = (10, 0, 0) in turned\n"


@pytest.mark.parametrize(
    "text",
    [
        "lin (10, 0, 0) in turned offset (5, 0, 0)",
        "lin a offset (5, 0, 0)",
        "lin g offset (5, 0, 0)",
        "q = a\nlin q offset (5, 0, 0)",
        "q = (10, 0, 0) in turned\nlin q offset (5, 0, 0)",
        "with frame turned\nq = (10, 0, 0)\nendwith\nlin q offset (5, 0, 0)",
        "with frame turned\nlin (10, 0, 0)\nq = here\nendwith\nlin q offset (5, 0, 0)",
        "with frame turned\nlin (10, 0, 0) store q\nendwith\nlin q offset (5, 0, 0)",
        "q = a offset (2, 0, 0)\nlin q offset (3, 0, 0)",
        "q = a\nq.y = q.y + 5\nlin q offset (0, 0, 0)",
        "q = a\nlin q above 4 offset (5, 0, -4)",
        "q = infeed\nq = a\nlin q offset (5, 0, 0)",
        "q = (10, 0, 0)\nlin q in turned offset (5, 0, 0)",
        "q = (10, 0, 0)\nr = q in turned\nlin r offset (5, 0, 0)",
        "q = (0, 0, 0) in turned\nr = infeed in turned\nlin a rel (0, 0, 0) offset (5, 0, 0)",
        "q = (0, 0, 0; rz 0) in turned\nlin a rel (0, 0, 0) rel (0, 0, 0) offset (5, 0, 0)",
        "task T(q: loc)\nlin q offset (5, 0, 0)\nendp\nT a",
        "task T(q: loc)\nlin q offset (5, 0, 0)\nendp\nT((10, 0, 0) in turned)",
        "task T(q: loc = (10, 0, 0) in turned)\nlin q offset (5, 0, 0)\nendp\nT",
        "task T(q: loc)\nset frame table\nlin q offset (5, 0, 0)\nendp\nT a",
        "task T -> loc\nreturn (10, 0, 0) in turned\nendp\nq = T()\nlin q offset (5, 0, 0)",
        "pattern s = grid 1 from (10, 0, 0) in turned step (1, 0, 0)\n"
        "for each q in s\nlin q offset (5, 0, 0)\nendf",
        "pattern s = grid 1 from (10, 0, 0) in turned step (1, 0, 0)\n"
        "for each q in s\nr = q\nendf\nlin a offset (5, 0, 0)",
    ],
)
def test_a_location_is_shifted_along_the_frame_in_which_it_was_given(text: str) -> None:
    """Whether it is written there, named, kept, passed, returned or taken from a pattern."""
    assert base_positions(NAMED + text)[-1] == pytest.approx((0.1, 0.015, 0.0), abs=ROUNDING)


@pytest.mark.parametrize(
    "text",
    [
        "lin infeed offset (5, 0, 0)",
        "set frame table\nlin infeed offset (5, 0, 0)",
        "with frame table\nlin infeed offset (5, 0, 0)\nendwith",
        "with frame table\nq = infeed\nlin q offset (5, 0, 0)\nendwith",
        "open\nset frame table\nq = infeed\nlin q offset (5, 0, 0)",
        "lin infeed\nlin here offset (5, 0, 0)",
    ],
)
def test_a_location_of_the_cell_is_shifted_along_the_base_frame(text: str) -> None:
    assert base_positions(f"units mm\n{text}")[-1] == pytest.approx((0.405, 0.3, 0.1), abs=ROUNDING)


@pytest.mark.parametrize("text", ["lin infeed offset (5, 0, 0)", "q = infeed\nlin q offset (5, 0, 0)"])
def test_a_location_that_the_cell_gives_in_a_frame_is_shifted_along_that(text: str) -> None:
    inside = replace(IN_FRAME, given={"infeed": TURNED})
    assert base_positions(f"units mm\n{text}", inside)[0] == pytest.approx((0.4, 0.305, 0.1), abs=ROUNDING)
    work = replace(inside, frame="table")
    assert base_positions(f"units mm\n{text}", work)[0] == pytest.approx((0.4, 0.305, 0.1), abs=ROUNDING)


def test_here_is_shifted_along_the_frame_in_force() -> None:
    here = "lin here offset (5, 0, 0)\n"
    text = f"units mm\nlin infeed\nwith frame table\n{here}endwith\n{here}"
    expected = [(0.4, 0.3, 0.1), (0.4, 0.305, 0.1), (0.405, 0.305, 0.1)]
    for found, wanted in zip(base_positions(text), expected, strict=True):
        assert found == pytest.approx(wanted, abs=ROUNDING)


def test_the_axes_of_the_step_of_rel_are_not_those_of_the_location() -> None:
    text = f"{NAMED}q = (0, 0, 0; rz 0) in turned\nlin infeed rel q\nr = infeed rel q\nlin r offset (5, 0, 0)"
    moved, shifted = base_positions(text)
    assert shifted == pytest.approx((moved[0] + 0.005, moved[1], moved[2]), abs=ROUNDING)


ON_PLATE = replace(
    IN_FRAME,
    frames={**IN_FRAME.frames, "plate": (0.0, 1.0, 0.5, 1.0, 0.0, 0.0, 0.0)},
    moving=frozenset({"plate"}),
)
"""With a frame on a positioner."""


@pytest.mark.parametrize(
    "move",
    [
        "q rel (x, 0, 0)",
        "q rel (x, 0, 0; rz 30) rel (0, 0, x)",
        "q rel r",
        "q above x",
        "q offset (x, 0, 0)",
        "(x, 0, 0) in plate rel (x, 0, 0)",
        "(q rel (x, 0, 0)) offset (0, 0, x)",
    ],
)
def test_a_location_on_a_positioner_stays_on_it_when_it_is_moved_by_computed_steps(move: str) -> None:
    text = f"program p\nunits mm\nx = 5\nr = infeed\nq = (10, 0, 0) in plate\nlin {move}"
    code = compiled(text, ON_PLATE).icr
    assert code is not None
    assert run(code).moves[0].modal.frame == "plate"


@pytest.mark.parametrize(
    "text",
    [
        "with frame table\nq = (x, 0, 0) in pallet\nprint q.x, q.y\nendwith",
        "with frame table\nprint (r in pallet).x, (r in pallet).y\nendwith",
        "with frame table\nload (a, b, c), r in pallet\nprint a, b\nendwith",
        "q = r rel (x, 0, 0)\nwith frame table\nprint q.x, q.y\nendwith",
        "q = r in table\nlin q rel (x, 0, 0)\nlin q offset (x, 0, 0)\nlin q above x",
    ],
)
def test_a_frame_that_moves_changes_nothing_for_locations_in_others(text: str) -> None:
    found = []
    for environment in (IN_FRAME, ON_PLATE):
        code = compiled(f"units mm\nx = 5\nr = infeed\n{text}", environment).icr
        assert code is not None
        targets = [move.target for move in run(code).moves]
        places = [part for one in targets if isinstance(one, Pose) for part in one.as_tuple()]
        found.append((run(code).messages, places))
    (said, places), (said_there, places_there) = found
    assert said == said_there
    assert places == pytest.approx(places_there, abs=ROUNDING)
