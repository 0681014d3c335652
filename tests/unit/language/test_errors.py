"""One finding per wrong line; all other lines still compile."""

from dataclasses import replace

import pytest

from ropsim import icr
from ropsim.program import SignalUse, ValueType
from support.outcomes import outcome
from support.tasks import CELL, codes, compiled, only

PROGRAM = """program p
units mm, deg, s
task Pick(part: loc, clear: length = 60 mm)
  mov part above clear
  lin part
  close
endp
task Place(slot: loc)
  mov slot
  open
endp
Pick infeed
Place (1, 2, 3) in pallet
"""


def test_the_words_of_paper_one_with_the_nearest_name() -> None:
    found = only("task release\n mov l\nendp\nrelase infeed\n")
    assert found.message == "Task not defined: `relase`"
    assert found.hint == "did you mean `release`?"
    assert found.fix is not None
    assert found.fix.replacement == "release"


def test_other_lines_of_a_wrong_text_still_compile() -> None:
    result = compiled(PROGRAM.replace("lin part", "lin part speed 5 s"))
    assert [d.code for d in result.diagnostics] == ["T302"]
    assert result.icr is None
    assert result.program is not None
    assert [len(t.body) for t in result.program.tasks] == [2, 2]
    assert len(result.program.main) == 2


def test_a_wrong_first_value_is_not_reported_again_at_each_use() -> None:
    assert codes("x = 5 s + 3 mm\ny = x + 1\nmov (x, y, 0)") == ["T302"]


@pytest.mark.parametrize("header", ["for i = 1 too 5", "repeat 2 2", "if part_ok ok", "while", "with sped 3"])
def test_a_broken_opener_still_opens_its_block(header: str) -> None:
    closer = {"for": "endf", "repeat": "endr", "if": "endif", "while": "endw", "with": "endwith"}
    assert codes(f"{header}\nopen\n{closer[header.split(maxsplit=1)[0]]}\nmov home") == ["L101"]


def test_a_broken_task_header_spoils_nothing_else() -> None:
    assert codes(PROGRAM.replace("(part: loc,", "(part loc,")) == ["L101"]


def test_an_unclosed_parenthesis_ends_at_the_next_statement() -> None:
    found = only("mov (1, 2, 3\nclose\nmov home")
    assert found.span is not None
    assert (found.code, found.span.line) == ("L101", 1)


def test_a_statement_may_go_on_in_the_next_lines() -> None:
    assert codes("units mm\nmov (1,\n 2,\n 3)\nlin infeed \\\n speed 20 mm/s") == []
    found = only("units mm\nmov (1,\n 2 s,\n 3)")
    assert found.span is not None
    assert (found.span.line, found.span.column, found.span.end_column) == (3, 2, 5)


def test_tabs_line_ends_and_byte_order_mark_keep_columns() -> None:
    found = only("\ufeffunits mm\r\n\tmov nowhere\r")
    assert found.span is not None
    assert (found.span.line, found.span.column, found.span.end_column) == (2, 6, 13)


def test_break_leaves_all_loops_of_a_pattern() -> None:
    from ropsim.icr import run

    text = """units mm
pattern s = grid 3 x 3 from (0, 0, 0) step (1, 0, 0), (0, 1, 0)
for each q in s
  if q.row = 2 then break
  mov q
endf
"""
    result = compiled(text)
    assert result.icr is not None
    assert len(run(result.icr).moves) == 3


def test_recursion_is_refused_with_the_chain() -> None:
    found = only("task a\n b\nendp\ntask b\n a\nendp\na\n")
    assert "a -> b -> a" in found.message


def test_crossed_blocks_have_one_finding() -> None:
    assert codes("repeat 2\nif true\nopen\nendr\nendif") == ["L106"]


def test_an_empty_text_is_a_warning() -> None:
    found = only("")
    assert (found.code, found.is_error) == ("L111", False)


def test_the_list_of_findings_ends_after_two_hundred() -> None:
    found = compiled("".join(f"mov nowhere{k}\n" for k in range(1000))).diagnostics
    assert len(found) == 201
    assert found[-1].code == "L110"


def test_every_kind_has_an_explanation() -> None:
    from ropsim.core import catalogue

    kinds = [k for k in catalogue().values() if k.code[0] in "LNT"]
    assert len(kinds) >= 38
    assert all(len(k.explanation) > 80 for k in kinds)


def test_a_tool_of_the_cell_that_the_station_does_not_have_is_told_as_such() -> None:
    other = replace(CELL, others_tools=frozenset({"cup"}))
    (found,) = compiled(PROGRAM.replace("  close", "  close cup"), other).diagnostics
    assert found.code == "N204"
    assert found.message == "the station does not have the tool `cup` of this cell"
    assert found.hint == 'give it to the station in the cell file: `tools = ["jaws", "cup"]`'


SWITCHES = replace(
    CELL,
    signals={**CELL.signals, "ready": SignalUse("ready", is_input=False, type=ValueType.BOOL)},
    told={"part_ok": "belt"},
)


READ_PLACED = "signals are read by name: write `wait until placed`"


@pytest.mark.parametrize(
    ("line", "code", "hint"),
    [
        ("mov infeed speed 150 mm", "T302", "give the value in `mm/s`, `deg/s` or `%`"),
        ("wait placed", "N202", f"{READ_PLACED}, and declare it in the cell file: `[signals.placed]`"),
        ("wait ready", "T301", "signals are read by name: write `wait until ready`"),
        ("wait until ready on", "L101", "inputs are read by name: write `wait until NAME`"),
        ("wait until ready off", "L101", "inputs are read by name: write `wait until not NAME`"),
        ("wait until reddy", "N202", "did you mean `ready`?"),
        ("wait until foo", "N202", "declare it in the cell file: `[signals.foo]`"),
        ("set foo on", "N205", "declare it in the cell file: `[signals.foo]`; there is only `ready`"),
        ("set part_ok on", "N207", "the device `belt` sets it"),
    ],
)
def test_signals_and_units_that_are_wrong_get_the_way_to_write_them(line: str, code: str, hint: str) -> None:
    (found,) = compiled(f"program p\nunits mm, deg, s\n{line}\n", SWITCHES).diagnostics
    assert (found.code, found.hint) == (code, hint)


def test_a_coordinate_for_a_station_without_an_arm_is_to_be_in_joints() -> None:
    slide = replace(CELL, axes=("length",), external=("length",))
    (found,) = compiled("program p\nunits mm, deg, s\nmov 900\n", slide).diagnostics
    assert found.code == "T301"
    assert "`mov joints(900)`" in found.hint


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("if 1 / n > 2\nopen\nelseif n = 1\nopen\nendif", 2),
        ("if n = 1\nx = 3\nelseif 1 / n > 2\nopen\nendif", 4),
        ("if n = 1\nx = 3\nelseif n = 2\nx = 4\nelseif 1 / n > 2\nopen\nelse\nclose\nendif", 6),
        ("repeat 3\nx = 3\nuntil 1 / n > 2", 4),
        ("repeat\nx = 3\nuntil 1 / n > 2", 4),
        ("while 1 / n > 2\nx = 3\nendw", 2),
        ("if n = 0 then y = 1 / n", 2),
        ("for i = 1 to round(1 / n)\nopen\nendf", 2),
    ],
)
def test_a_trap_stands_at_the_line_whose_condition_it_is(text: str, line: int) -> None:
    assert outcome(f"var n: int = 0\n{text}").trap == ("I460", line)


@pytest.mark.parametrize(
    "text",
    [
        "j = home\nmov j",
        "task T(j: joints)\n mov j\nendp\nT home",
        "task T(j: joints)\n mov j\nendp\nT(home)",
        "print home",
        "x = home == home",
        "if home then open",
        "mov (home, 1, 2)",
        "task T(j: joints = home)\n mov j\nendp\nT",
        "task T() -> joints\n return home\nendp\nT()",
        "lin infeed above home",
    ],
)
def test_home_is_where_a_motion_goes_and_no_value(text: str) -> None:
    found = only(text)
    assert found.code == "T334"
    assert "mov home" in found.hint


def test_home_is_a_target_and_a_point_on_the_way() -> None:
    assert codes("mov home\nmov via home to infeed\nmov (home) speed 30 %") == []


@pytest.mark.parametrize(
    "line", ["elseif(part_ok)", "elseif (part_ok) then", "else# note", "else // note", "ELSE"]
)
def test_a_branch_needs_no_blank_behind_its_word(line: str) -> None:
    assert codes(f"n = 1\nif n > 4\n n = 2\n{line}\n n = 3\nendif") == []


@pytest.mark.parametrize("line", ["return 5 s", "return nowhere", "retrun 5 mm", "return 5 5", "return"])
def test_a_wrong_return_is_not_missed_as_well(line: str) -> None:
    assert len(codes(f"task T() -> length\n {line}\nendp\nx = T()")) == 1


@pytest.mark.parametrize("condition", ["n > 3", "false", "n = 1 and q.x > 3 mm"])
def test_a_wait_for_what_nothing_changes_is_a_warning(condition: str) -> None:
    text = f"q = (1, 2, 3)\nn = 1\nprint q, n\nwait until {condition}"
    found = only(text)
    assert (found.code, found.is_error) == ("T336", False)
    assert codes(f"{text} or part_ok") == []


@pytest.mark.parametrize(
    ("text", "code", "line", "marked"),
    [
        ("if part_ok\n x = 1\nendif\nprint 2, x", "T391", 4, (10, 11)),
        ("if part_ok\n x = 1\nendif\nx = 1 + x", "T391", 4, (9, 10)),
        ("if part_ok\n q = infeed\nendif\nlin q above 30", "T392", 4, (5, 6)),
        ("if part_ok\n q = infeed\nendif\nlin (1, 2,\n  3; like q)", "T392", 5, (11, 12)),
        ("if part_ok\n q = infeed\nendif\nq.x = 3", "T392", 4, (1, 2)),
    ],
)
def test_a_name_without_value_is_marked_where_it_is_read(
    text: str, code: str, line: int, marked: tuple[int, int]
) -> None:
    found = only(text)
    assert found.span is not None
    assert found.code == code
    assert (found.span.line, found.span.end_line) == (line, line)
    assert (found.span.column, found.span.end_column) == marked


MODERN = "program p\nunits mm, deg, s\n"


@pytest.mark.parametrize(
    ("text", "code", "place", "words"),
    [
        ("program p\nunits mm, cm\nlin infeed", "T340", (2, 11), "in `mm` and in `cm`"),
        ("program p\nunits mm\nlin infeed\nunits inch", "T340", (4, 7), "in `mm` and in `inch`"),
        ("program p\nunits deg, rad", "T340", (2, 12), "in `deg` and in `rad`"),
        (MODERN + "frame base = (0, 0, 100)", "N206", (3, 7), "`base` is the base frame of the robot"),
        (
            MODERN + "with frame pallet, frame base\n  open\nendwith",
            "T303",
            (3, 20),
            "`frame` is given twice",
        ),
        (
            MODERN + f"lin (300, 0, 100; turns ({', '.join('0' * 33)}))",
            "T306",
            (3, 19),
            "`turns` has 33 numbers",
        ),
        (MODERN + f"{'x' * 201} = 3", "L114", (3, 1), "a name has 201 characters, at most 200 are allowed"),
        (MODERN + f"task {'x' * 201}\nendp", "L114", (3, 6), "a name has 201 characters"),
    ],
)
def test_what_was_taken_in_silence_is_told(text: str, code: str, place: tuple[int, int], words: str) -> None:
    found = next(one for one in compiled(text).diagnostics if one.is_error)
    assert found.code == code
    assert words in found.message
    assert found.span is not None
    assert (found.span.line, found.span.column) == place


def test_a_unit_named_twice_is_no_mistake() -> None:
    assert compiled("program p\nunits mm, deg\nunits mm, s\nlin infeed").diagnostics == ()


def test_the_longest_names_make_code() -> None:
    name = "x" * 199
    task = f"task T{name}(a: int)\n  print a\nendp\n"
    code = compiled(f"{MODERN}{task}x{name} = 3\nfor y{name} = 1 to 2 do\n  T{name} x{name}\nendf").icr
    assert code is not None
    read, found = icr.read_binary(icr.encoded(code))
    assert found == ()
    assert read is not None
    assert icr.program_id(read) == icr.program_id(code)


def test_a_long_name_in_a_line_like_many_others_is_told() -> None:
    """Lines of one shape are read by what the first of them has taught."""
    lines = [f"a{'x' * k}{k} = {k}" for k in range(100, 300, 20)]
    found = [one for one in compiled(MODERN + "\n".join(lines)).diagnostics if one.code == "L114"]
    assert len(found) == sum(len(line.partition(" ")[0]) > 200 for line in lines)
