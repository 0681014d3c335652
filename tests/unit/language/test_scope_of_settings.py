"""Where settings end: a frame with its block, one-line or not; all that is set inside a `with` at its end."""

import pytest

from ropsim.flow import MoveInstruction
from ropsim.spatial import Pose
from support.outcomes import outcome
from support.tasks import codes, compiled, only

HEAD = "program p\nunits mm, deg, s\nlin infeed\n"
"""A move, so that no `set frame` below chooses the work frame."""


def moves(text: str) -> tuple[MoveInstruction, ...]:
    """Return the moves of a text behind the head, where `part_ok` is on."""
    found = outcome(HEAD + text, {"part_ok": True})
    assert found.trap is None
    return found.moves[1:]


def at(move: MoveInstruction) -> tuple[float, ...]:
    """Return where a move goes in the base frame [mm]."""
    assert isinstance(move.target, Pose)
    return tuple(round(1e3 * one, 6) for one in (move.modal.X_BK @ move.target).as_tuple()[:3])


SETTINGS = ("speed 20", "speed 30 %", "speed 40 deg/s", "acc 300", "acc 20 %", "blend 5", "tool spare")


@pytest.mark.parametrize("header", ["frame pallet", "frame pallet, speed 50", "speed 50", "tool jaws"])
@pytest.mark.parametrize("setting", SETTINGS)
@pytest.mark.parametrize(
    "where", ["{}\nlin infeed above 9", "Change\nlin infeed above 9", "if true then {}\nlin infeed above 9"]
)
def test_a_with_brings_back_what_is_set_inside_whatever_its_header_names(
    header: str, setting: str, where: str
) -> None:
    task = f"tool spare = (0, 0, 99)\ntask Change\nset {setting}\nendp\n"
    inside = where.format(f"set {setting}")
    text = f"{task}lin infeed above 1\nwith {header}\n{inside}\nendwith\nlin infeed above 2"
    before, within, after = moves(text)
    assert before.modal == after.modal
    assert within.modal != after.modal


@pytest.mark.parametrize("way", ["break", "continue", "return"])
def test_a_way_out_of_a_with_of_a_frame_brings_back_what_was_set(way: str) -> None:
    loop = ("repeat 1\n", "\nendr") if way != "return" else ("", "")
    text = (
        f"task T\n{loop[0]}with frame pallet\nset speed 20\nlin (0, 0, 5)\nif true then {way}\n"
        f"endwith{loop[1]}\nendp\n"
        "lin infeed above 1\nT\nlin infeed above 2"
    )
    before, within, after = moves(text)
    assert before.modal == after.modal
    assert within.modal != after.modal


ONE_LINE = (
    "if part_ok then set frame pallet",
    "if not part_ok then set frame pallet",
    "if part_ok then if part_ok then set frame pallet",
    "wait until part_ok timeout 1 s else set frame pallet",
    "wait until false timeout 1 s else set frame pallet",
)
BLOCKS = (
    "if part_ok\nset frame pallet\nendif",
    "if not part_ok\nset frame pallet\nelse\nopen\nendif",
    "repeat 1\nset frame pallet\nendr",
    "while not part_ok\nset frame pallet\nbreak\nendw",
    "for i = 1 to 1\nset frame pallet\nendf",
)


@pytest.mark.parametrize("text", [*ONE_LINE, *BLOCKS])
def test_a_frame_set_in_a_body_ends_with_it_and_acts_on_no_line_below(text: str) -> None:
    found = [one for one in compiled(f"{HEAD}{text}\nlin (0, 0, 5)").diagnostics if one.code == "T314"]
    assert [one.is_error for one in found] == [False]
    assert found[0].message.startswith("`set frame pallet` ends with its block")
    assert at(moves(f"{text}\nlin (0, 0, 5)")[-1]) == (0.0, 0.0, 5.0)


@pytest.mark.parametrize("ready", [True, False])
def test_a_wait_whose_else_sets_a_frame_has_an_else(ready: bool) -> None:
    """It does not end the program where time is up."""
    text = f"{HEAD}wait until part_ok timeout 1 s else set frame pallet\nlin (0, 0, 5)"
    found = outcome(text, {"part_ok": ready})
    assert found.trap is None
    assert at(found.moves[-1]) == (0.0, 0.0, 5.0)


@pytest.mark.parametrize("before", ["", "set frame pallet\n"])
def test_the_frame_around_a_body_holds_on_behind_it(before: str) -> None:
    text = f"{before}if not part_ok then set frame base\nlin (0, 0, 5)"
    assert at(moves(text)[-1]) == ((400.0, -300.0, 5.0) if before else (0.0, 0.0, 5.0))


def test_the_first_location_below_a_block_that_set_a_frame_is_told() -> None:
    text = f"{HEAD}if part_ok\nset frame pallet\nlin (0, 0, 7)\nendif\nlin (0, 0, 5)\nlin (0, 0, 6)"
    found = only(text)
    assert (found.code, found.span and found.span.line) == ("T315", 8)
    assert "`pallet`" in found.message


@pytest.mark.parametrize(
    "read",
    [
        "lin (0, 0, 5)",
        "q = infeed\nprint q.x",
        "q = infeed\nq.x = 5\nlin q",
        "load (x, y, z), infeed\nprint x, y, z",
        "lin here offset (0, 0, 5)",
        "lin infeed in pallet",
        "lin (0, 0, 5; like infeed)",
    ],
)
def test_whatever_is_read_in_the_frame_in_force_is_told_below_such_a_block(read: str) -> None:
    text = f"{HEAD}repeat 2\nset frame pallet\nlin (0, 0, 7)\nendr\n{read}"
    assert codes(text) == ["T315"]


@pytest.mark.parametrize(
    "text",
    [
        "if part_ok\nset frame pallet\nlin (0, 0, 7)\nendif\nset frame base\nlin (0, 0, 5)",
        "if part_ok\nset frame pallet\nlin (0, 0, 7)\nendif\nwith frame base\nlin (0, 0, 5)\nendwith",
        "if part_ok\nset frame pallet\nlin (0, 0, 7)\nendif\nlin infeed\nlin (0, 0, 5) in base",
        "set frame pallet\nif part_ok\nset frame pallet\nlin (0, 0, 7)\nendif\nlin (0, 0, 5)",
        "with speed 20\nset frame pallet\nlin (0, 0, 7)\nendwith\nlin (0, 0, 5)",
        "with frame pallet\nlin (0, 0, 7)\nendwith\nlin (0, 0, 5)",
    ],
)
def test_nothing_is_told_where_the_frame_of_the_lines_below_is_written(text: str) -> None:
    assert codes(HEAD + text) == []


def test_a_wrong_line_may_have_been_read_in_the_frame() -> None:
    assert codes(f"{HEAD}if part_ok\nset frame pallet\nlni (0, 0, 7)\nendif") == ["N201"]
