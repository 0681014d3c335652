"""Names that mean two things are told: functions and tasks, parameters and what the cell has."""

from dataclasses import replace

import pytest

from ropsim.language import compile_library
from ropsim.program import SignalUse, ValueType
from support.outcomes import outcome
from support.tasks import CELL, codes, compiled, only

WORLD = replace(
    CELL,
    signals={
        **CELL.signals,
        "glue": SignalUse("glue", is_input=False, type=ValueType.BOOL),
        "force": SignalUse("force", is_input=True, type=ValueType.REAL),
    },
)
FUNCTIONS = ("dist", "sqrt", "sin", "atan2", "abs", "min", "max", "round", "trunc")


@pytest.mark.parametrize("name", [*FUNCTIONS, "Round", "SQRT"])
def test_no_task_has_the_name_of_a_function(name: str) -> None:
    found = only(f"program p\ntask {name}(x: num) -> num\nreturn x + 100\nendp\na = {name}(9)\nprint a")
    assert (found.code, found.span and found.span.line) == ("N222", 2)


@pytest.mark.parametrize(
    ("parameter", "hidden"),
    [
        ("part_ok: bool", "an input"),
        ("glue: bool", "an output"),
        ("force: num", "an analog input"),
        ("infeed: loc", "a location"),
        ("corner: loc", "a location"),
        ("count: int", "a variable"),
        ("gap: length", "a constant"),
        ("slots: int", "a pattern"),
        ("pallet: loc", "a frame"),
        ("shelf: loc", "a frame"),
        ("jaws: int", "a tool"),
        ("Go: int", "a task"),
    ],
)
def test_a_parameter_that_hides_another_name_is_told_at_its_place(parameter: str, hidden: str) -> None:
    text = f"""program p
units mm
loc corner = (1, 2, 3)
var count: int = 0
const gap = 3 mm
pattern slots = grid 2 from (0, 0, 40) step (70, 0, 0)
frame shelf = (1, 2, 3)
task T({parameter})
  open
endp
task Go
  open
endp
"""
    found = next(one for one in compiled(text + "open", WORLD).diagnostics if one.code == "N223")
    name = parameter.split(":", maxsplit=1)[0]
    assert found.is_error
    assert found.message == f"parameter `{name}` hides {hidden} of that name in the whole task"
    assert found.span is not None
    assert (found.span.line, found.span.column) == (8, 8)


DECLARED = """program p
units mm
frame shelf = (1, 2, 3)
tool probe = (1, 2, 3)
loc corner = (1, 2, 3)
const gap = 3 mm
pattern slots = grid 2 from (0, 0, 40) step (70, 0, 0)
task Give -> loc
  return infeed
endp
"""
OF_CELL = ("part_ok", "glue", "force", "infeed", "pallet", "jaws")
OF_TEXT = ("shelf", "probe", "corner", "gap", "slots", "Give")


@pytest.mark.parametrize("name", [*OF_CELL, *OF_TEXT])
@pytest.mark.parametrize(
    "line",
    [
        "{} = 3",
        "{} = (1, 2, 3)",
        "{} = Give()",
        "for {} = 1 to 3\nendf",
        "for each {} in slots\nendf",
        "load (x, {}, z), (1, 2, 3)",
        "lin (1, 2, 3) store {}",
        "if part_ok then {} = 3",
    ],
)
@pytest.mark.parametrize("body", ["task T\n{}\nendp\nT", "open\n{}"])
def test_no_variable_takes_the_name_of_something_declared(line: str, name: str, body: str) -> None:
    found = compiled(DECLARED + body.format(line.format(name)), WORLD).diagnostics
    assert [one.code for one in found if one.is_error] == ["N207"]


@pytest.mark.parametrize("name", OF_TEXT)
@pytest.mark.parametrize(
    "line",
    [
        "frame {} = (1, 2, 3)",
        "tool {} = (1, 2, 3)",
        "loc {} = (1, 2, 3)",
        "const {} = 3",
        "var {}: int",
        "signal {} = input 3",
        "pattern {} = grid 2 from (0, 0, 0) step (1, 0, 0)",
    ],
)
def test_no_two_declarations_share_a_name_whatever_they_declare(line: str, name: str) -> None:
    found = compiled(f"{DECLARED}{line.format(name)}\nopen", WORLD).diagnostics
    assert [one.code for one in found if one.is_error] == ["N206"]


@pytest.mark.parametrize("name", OF_CELL)
def test_no_task_has_the_name_of_something_in_the_cell(name: str) -> None:
    found = only(f"program p\ntask {name}\n  open\nendp\n{name}", WORLD)
    assert (found.code, found.is_error, found.span and found.span.line) == ("N223", True, 2)


def test_a_frame_that_a_wrong_line_would_have_assigned_is_still_the_frame() -> None:
    found = compiled(
        "program p\nunits mm\npallet = (1, 2, 3)\nlin (0, 0, 5) in pallet\nlin pallet"
    ).diagnostics
    assert [(one.code, one.span and one.span.line) for one in found] == [("N207", 3)]


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("task Pick(q: loc)\n  lin q\nendp\npick infeed", [4]),
        ("task Pick(q: loc)\n  lin q\nendp\nPick infeed", []),
        ("task Pick(q: loc)\n  lin q\nendp\nPick infeed\nif part_ok then pick infeed", [5]),
        (
            "task Pick(q: loc)\n  lin q\nendp\ntask PICK(q: loc)\n  open\nendp\nPick infeed\nPICK infeed",
            [7, 8],
        ),
        ("task Go\n  pick infeed\nendp\ntask Pick(q: loc)\n  lin q\nendp\nGo\nPick infeed", [2]),
        ("pick infeed", []),
    ],
)
def test_a_call_of_a_task_that_another_one_differs_from_by_case_is_told(text: str, lines: list[int]) -> None:
    _, made = compile_library("program l\ntask pick(q: loc)\n  lin q\n  close\nendp")
    found = compiled(text, replace(WORLD, tasks=made)).diagnostics
    assert [one.span and one.span.line for one in found if one.code == "N217"] == lines


def test_such_a_call_of_the_library_names_both_tasks_and_offers_that_of_the_text() -> None:
    _, made = compile_library("program l\ntask pick(q: loc)\n  lin q\nendp")
    text = "program p\ntask Pick(q: loc)\n  lin q above 5\nendp\npick infeed"
    found = next(one for one in compiled(text, replace(WORLD, tasks=made)).diagnostics if one.code == "N217")
    assert found.message == "`pick` is a task of the library, and this text has a task `Pick`"
    assert found.fix is not None
    assert found.fix.replacement == "Pick"


def test_a_call_of_the_library_whose_tasks_differ_by_case_names_both() -> None:
    _, made = compile_library("program l\ntask pick(q: loc)\n  lin q\nendp\ntask Pick(q: loc)\n  open\nendp")
    world = replace(WORLD, tasks=made)
    (found,) = [one for one in compiled("pick infeed", world).diagnostics if one.code == "N217"]
    assert found.message == "the tasks `pick` and `Pick` of the library differ by upper and lower case only"
    own = "task Pick(q: loc)\n  open\nendp\nPick infeed"
    assert [one.code for one in compiled(own, world).diagnostics] == []


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ("signal part_ok = input 7", ""),
        ("signal glue = output 7", ""),
        ("signal force = analog input 7", ""),
        ("signal part_ok = output 7", "N224"),
        ("signal part_ok = analog input 7", "N224"),
        ("signal force = input 7", "N224"),
        ("signal glue = input 7", "N224"),
        ("loc infeed = (1, 2, 3)", "N214"),
        ("loc part_ok = (1, 2, 3)", "N223"),
        ("const part_ok = true", "N223"),
        ("var glue: bool = true", "N223"),
        ("const infeed = 3", "N223"),
        ("signal infeed = input 3", "N223"),
        ("pattern infeed = grid 2 from (0, 0, 0) step (1, 0, 0)", "N223"),
    ],
)
def test_a_declaration_that_has_the_name_of_something_in_the_cell_is_told(line: str, code: str) -> None:
    assert codes(f"program p\n{line}\nopen", WORLD) == ([code] if code else [])


def test_a_location_that_the_cell_has_too_is_where_the_cell_says() -> None:
    text = "program p\nunits mm\nloc infeed = (1, 2, 3)\nprint infeed.x, infeed.y, infeed.z"
    assert outcome(text).says == ("400 mm 300 mm 100 mm",)
