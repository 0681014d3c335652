"""Completion, hover, definition and outline."""

from pathlib import Path

import pytest

from ropsim import language
from ropsim.lsp.completion.call_place import _TEXT
from ropsim.lsp.testing import call_place, words
from ropsim.workbench import new_project
from support.editors import Editor, place, uri_of

BARE = "file:///nowhere-at-all/x.task"
HEAD = """program p
units mm, deg, s
loc corner = (1, 2, 3)
const gap = 12 mm
pattern slots = grid 2 x 2 from (0, 0, 40) step (70, 0, 0), (0, 90, 0)

# Takes a part
# from above.
task Pick(part: loc, clear: length = 60, n = 2) -> int
  needs gripper open
  total = n + 1
  lin part above clear
  close
  return total
endp
"""


@pytest.fixture
def program(tmp_path: Path) -> str:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    cell = folder / "cell.toml"
    cell.write_text(cell.read_text("utf-8") + "\n[signals.part_ok]\ninput = 1\n", "utf-8")
    return uri_of(folder / "programs" / "x.task")


def labels(uri: str, marked: str) -> list[str]:
    items = Editor().at_mark("completion", uri, marked)["items"]
    return [item["label"] for item in sorted(items, key=lambda item: item["sortText"])]


def hover(uri: str, marked: str) -> str:
    value: str = Editor().at_mark("hover", uri, marked)["contents"]["value"]
    return value


def test_every_word_of_the_language_is_explained() -> None:
    assert set(words.STATEMENTS) == language.STATEMENT_WORDS
    assert set(words.INNER) == language.INNER_WORDS
    assert set(words.LOCATIONS) == language.LOCATION_WORDS
    assert set(words.MOTIONS) == language.MOTION_WORDS
    assert set(words.FUNCTIONS) == language.FUNCTIONS
    assert set(words.TYPES) == language.TYPE_WORDS


def test_the_variable_of_a_loop_is_offered_in_its_lines_alone() -> None:
    head = HEAD + "total = 1\n"
    assert {"slot", "total"} <= set(labels(BARE, head + "for each slot in slots\n  x = |\nendf\n"))
    behind = labels(BARE, head + "for each slot in slots\n  x = 2\nendf\nprint |\nlater = 3\n")
    assert {"total", "x"} <= set(behind)
    assert not {"slot", "later", "part", "clear"} & set(behind)


def test_a_frame_and_a_location_of_one_name_are_both_offered() -> None:
    head = HEAD + "frame corner = (4, 5, 6)\n"
    assert "corner" in labels(BARE, head + "lin corner in |")
    assert "corner" in labels(BARE, head + "lin |")


def test_a_line_begins_with_tasks_then_statement_words() -> None:
    offered = labels(BARE, HEAD + "P|")
    assert offered[0] == "Pick"
    assert {"mov", "repeat", "with"} <= set(offered)
    assert "sqrt" not in offered


def test_a_task_is_offered_with_its_signature_and_its_comment() -> None:
    items = Editor().at_mark("completion", BARE, HEAD + "call |")["items"]
    pick, *library = items
    assert {one["label"] for one in library} >= {"pick", "palletize"}
    assert pick["detail"] == "(part: loc, clear: length [mm] = 60, n: int = 2) -> int"
    assert pick["documentation"]["value"] == "Takes a part from above. needs gripper open"


@pytest.mark.parametrize(
    ("line", "among"),
    [
        ("lin |", "corner"),
        ("x = 3 * |", "sqrt"),
        ("circ |", "via"),
        ("circ via |", "corner"),
        ("spline via corner, |", "corner"),
        ("lin via corner to |", "corner"),
        ("circ via corner to corner above 3 mm |", "angle"),
        ("circ via corner to corner angle 90 |", "deg"),
        ("lin corner |", "at"),
        ("mov (1, 2, 3; |", "config"),
        ("lin corner |", "until"),
        ("lin corner |", "store"),
        ("signal lamp = output 1\nlin corner until |", "lamp"),
        ("lin corner until lamp timeout |", "1 s"),
        ("lin corner at |", "gap"),
        ("lin corner at 3 |", "mm"),
        ("lin corner at 3 mm |", "after start"),
        ("lin corner at gap |", "before end"),
        ("lin corner at gap before end do |", "set"),
        ("signal lamp = output 1\nlin corner at gap before end do set |", "lamp"),
        ("lin corner |", "speed"),
        ("lin corner above 3 |", "mm"),
        ("for each q in |", "slots"),
        ("lin corner in |", "base"),
        ("lin (1, 2, 3; |", "rpy"),
        ("corner.|", "x"),
        ("const k: |", "length"),
        ("units |", "mm"),
        ("if true then |", "mov"),
    ],
)
def test_a_place_offers_what_may_stand_there(line: str, among: str) -> None:
    assert among in labels(BARE, HEAD + line)


@pytest.mark.parametrize(
    ("line", "first"),
    [
        ("Pick |", "corner"),
        ("call Pick |", "corner"),
        ("Pick corner, |", "gap"),
        ("Pick (1, 2, 3), |", "gap"),
        ("Pick(corner, |", "gap"),
        ("Pick corner, clear = |", "gap"),
        ("x = Pick(|", "corner"),
        ("lin |", "corner"),
        ("lin corner above |", "gap"),
        ("wait |", "1 s"),
        ("lin corner speed |", "100 mm/s"),
    ],
)
def test_what_fits_the_type_of_a_place_comes_first(line: str, first: str) -> None:
    assert labels(BARE, HEAD + line)[0] == first


def test_literals_with_a_unit_come_after_the_names_that_fit() -> None:
    offered = labels(BARE, HEAD + "const far = 3 s\nPick corner, |")
    assert offered[:2] == ["gap", "10 mm"]
    assert offered.index("0.1 m") < offered.index("far")


@pytest.mark.parametrize(
    ("line", "unfit"),
    [
        ("Pick |", ("k", "far", "and", "do", "false", "sqrt")),
        ("lin |", ("k", "far", "not", "abs")),
        ("Pick corner, |", ("corner", "and", "do")),
        ("wait |", ("corner", "then")),
    ],
)
def test_what_cannot_stand_at_a_place_is_not_offered(line: str, unfit: tuple[str, ...]) -> None:
    offered = labels(BARE, HEAD + f"const far = 3 s\nfor k = 1 to 3\n{line}")
    assert set(offered).isdisjoint(unfit)


@pytest.mark.parametrize(
    ("line", "offered"), [("Pick |", True), ("Pick corner, |", True), ("mov |", False), ("x = 1 |", False)]
)
def test_a_blank_asks_inside_of_a_call_only(line: str, offered: bool) -> None:
    context = {"triggerKind": 2, "triggerCharacter": " "}
    items = Editor().at_mark("completion", BARE, HEAD + line, context=context)["items"]
    assert bool(items) is offered


def test_names_of_the_cell_are_offered_where_they_fit(program: str) -> None:
    assert "infeed" in labels(program, HEAD + "mov |")
    assert labels(program, HEAD + "lin (1, 2, 3) in |") == ["base", "pallet"]
    assert labels(program, HEAD + "close |") == ["jaws"]
    assert "part_ok" in labels(program, HEAD + "wait until |")


@pytest.mark.parametrize("line", ["# mo|", "// mo|", 'print "mo|', "loc |", "task |"])
def test_nothing_is_offered_in_comments_texts_and_new_names(line: str) -> None:
    assert labels(BARE, HEAD + line) == []


def test_behind_a_closed_text_names_are_offered_again() -> None:
    assert "total" in labels(BARE, 'total = 3\nprint "a \\" b", to|')


def test_a_line_of_many_quotes_is_read_once() -> None:
    for lead in ('Go "' + '\\"' * 1000, 'Go \\"' + '\\"' * 1000):
        assert call_place(lead, {}) is None
        assert sum(len(one[0]) for one in _TEXT.finditer(lead)) == len(lead) - lead.index('"')


def test_variables_of_a_task_are_offered_inside_of_it_only() -> None:
    inside = HEAD.replace("  close\n", "  x = |\n")
    assert {"part", "clear", "total"} <= set(labels(BARE, inside))
    assert not {"part", "clear", "total"} & set(labels(BARE, HEAD + "x = |"))


def test_hover_tells_how_a_task_is_called() -> None:
    told = hover(BARE, HEAD + "Pi|ck corner")
    assert "task Pick(part: loc, clear: length [mm] = 60, n: int = 2) -> int" in told
    assert "Takes a part" in told
    assert "needs gripper open" in told


def test_hover_tells_the_types_that_use_has_told() -> None:
    text = 'task "Palletize"\n  mov l2\n  x = a * 0.5 cm\n  repeat b\n  open\n  endr\nendp\nPal|letize 1\n'
    assert "task Palletize(l1: loc, l2: loc, a: num, b: int)" in hover(BARE, text)


def test_hover_tells_the_pose_of_the_cell_in_millimetres_and_degrees(program: str) -> None:
    told = hover(program, HEAD + "mov inf|eed")
    assert "(-40, -600, 600) mm, roll pitch yaw (180, 8, 0)° in the world frame" in told


def test_hover_tells_in_which_frame_a_location_moves(program: str, tmp_path: Path) -> None:
    cell = tmp_path / "cell" / "cell.toml"
    text = cell.read_text("utf-8").replace(
        "[robot]\n",
        "[robot]\npositioner = { radius = 200, height = 300, base = { position = [0, 900, 0] } }\n",
    )
    text += '\n[frames.nest]\nparent = "positioner"\nposition = [0, 50, 20]\n'
    text += '[locations.seat]\nframe = "nest"\nposition = [10, 0, 40]\n'
    cell.write_text(text, "utf-8")
    assert "(10, 0, 40) mm, roll pitch yaw (180, 0, 0)° in the frame nest" in hover(
        program, HEAD + "mov se|at"
    )
    assert "(0, 50, 20) mm" in hover(program, HEAD + "mov (0, 0, 0) in ne|st")


def test_hover_tells_what_a_signal_is(program: str) -> None:
    assert "input, off at the start" in hover(program, HEAD + "wait until part_|ok")


def test_hover_tells_what_a_word_means() -> None:
    assert "straight line" in hover(BARE, HEAD + "li|n corner")


def test_hover_on_a_finding_tells_its_code() -> None:
    assert "`ropsim explain N201`" in hover(BARE, HEAD + "Pi|kc corner")


def test_text_of_a_user_is_no_markup_in_a_hover() -> None:
    told = hover(BARE, "program p\n# <img src=x onerror=y> ``` [a](b)\ntask T\n  open\nendp\nT|\n")
    assert "\\<img" in told
    assert "\\[a\\](b)" in told


def test_nothing_is_known_about_an_empty_place() -> None:
    assert Editor().at_mark("hover", BARE, "program p\n  |\nmov home\n") is None


@pytest.mark.parametrize(
    ("line", "defined"),
    [("Pi|ck corner", (8, 5)), ("lin cor|ner", (2, 4)), ("for each q in slo|ts\nendf", (4, 8))],
)
def test_definition_is_the_line_of_the_name(line: str, defined: tuple[int, int]) -> None:
    found = Editor().at_mark("definition", BARE, HEAD + line)
    assert found["uri"] == BARE
    assert found["range"]["start"] == place(*defined)


def test_definition_of_a_parameter_is_in_the_header() -> None:
    found = Editor().at_mark("definition", BARE, HEAD.replace("lin part", "lin pa|rt"))
    assert found["range"] == {"start": place(8, 10), "end": place(8, 14)}


def test_definition_of_a_name_of_the_cell_is_in_the_cell_file(program: str) -> None:
    found = Editor().at_mark("definition", program, HEAD + "mov inf|eed")
    assert found["uri"].endswith("/cell/cell.toml")
    cell = (Path(found["uri"].removeprefix("file://"))).read_text("utf-8").splitlines()
    assert cell[found["range"]["start"]["line"]] == "[locations.infeed]"


def test_nobody_knows_where_a_word_of_the_language_is_defined() -> None:
    assert Editor().at_mark("definition", BARE, HEAD + "l|in corner") is None


def test_the_outline_lists_tasks_and_declarations() -> None:
    editor = Editor()
    editor.open(BARE, HEAD)
    found = editor.ask("textDocument/documentSymbol", textDocument={"uri": BARE})
    assert [one["name"] for one in found] == ["corner", "gap", "slots", "Pick"]
    assert found[-1]["range"]["end"]["line"] == 14


def test_values_of_external_axes_are_offered_behind_a_location_and_explained() -> None:
    for line in ("mov corner |", "loc stock = corner |", "lin corner above gap |"):
        assert "external" in labels(BARE, HEAD + line)
    assert "external" not in labels(BARE, HEAD + "mov |")
    assert "location external (e1, …)" in hover(BARE, HEAD + "mov corner exter|nal (800)")


def test_hover_over_a_location_tells_where_its_external_axes_stand(tmp_path: Path) -> None:
    folder = tmp_path / "cell"
    new_project(folder, "palletizing")
    cell = folder / "cell.toml"
    text = cell.read_text("utf-8").replace("[robot]\n", "[robot]\ntrack = { length = 2000 }\n", 1)
    cell.write_text(text + "\n[locations.stock]\nposition = [800, 0, 500]\nexternal = [800]\n", "utf-8")
    told = hover(uri_of(folder / "programs" / "x.task"), HEAD + "mov sto|ck")
    assert "(800, 0, 500) mm" in told
    assert told.endswith("external axes: E1 800 mm")


def test_the_postures_offered_are_those_of_the_robot(program: str) -> None:
    line = HEAD + "mov (1, 2, 3; config (left, |"
    assert set(labels(program, line)) == {"left", "right", "up", "down", "noflip", "flip"}
    assert labels(BARE, line) == []
