"""Names that mean two things are told: functions and tasks, parameters and what the cell has."""

from dataclasses import replace

import pytest

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
    ],
)
def test_a_parameter_that_hides_another_name_is_told_at_its_place(parameter: str, hidden: str) -> None:
    text = f"""program p
units mm
loc corner = (1, 2, 3)
var count: int = 0
const gap = 3 mm
pattern slots = grid 2 from (0, 0, 40) step (70, 0, 0)
task T({parameter})
  open
endp
"""
    found = next(one for one in compiled(text + "open", WORLD).diagnostics if one.code == "N223")
    name = parameter.split(":", maxsplit=1)[0]
    assert not found.is_error
    assert found.message == f"parameter `{name}` hides {hidden} of that name in the whole task"
    assert found.span is not None
    assert (found.span.line, found.span.column) == (7, 8)


@pytest.mark.parametrize("name", ["part_ok", "glue", "force", "infeed"])
@pytest.mark.parametrize(
    "line", ["{} = 3", "for {} = 1 to 3\nendf", "load (x, {}, z), (1, 2, 3)", "lin (1, 2, 3) store {}"]
)
def test_no_variable_takes_the_name_of_a_signal_or_location(line: str, name: str) -> None:
    text = f"program p\ntask T\n{line.format(name)}\nendp\nT"
    assert codes(text, WORLD) == ["N207"]


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
