import pytest

from ropsim.icr import AssemblyError, Constant, Step, Type, assemble, disassemble, read_text

HEADER = "ICR 1.0 t\n"


def found(text: str) -> list[tuple[str, int, int]]:
    """Return code, line and column of each diagnostic."""
    _, diagnostics = read_text(text, "t.icr")
    return [(one.code, one.span.line, one.span.column) for one in diagnostics if one.span]


def in_main(*lines: str) -> str:
    return HEADER + "PROC main\n" + "".join(f"  {line}\n" for line in lines) + "END\n"


def test_declarations_and_code_are_read() -> None:
    program = assemble(
        'ICR 1.0 t\nSOURCE "a b.task"\nREQUIRE AXES 6\nREQUIRE CAP PTP LIN\nVAR x REAL\nIO AI force REAL\n'
        "FRAMEDEF f 1 2 3 1 0 0 0\nTOOLDEF jaws\n"
        "PROC main\nLOCAL k INT\n  PUSH INT 4 ; four\n  STORE k\n  HALT\nEND\n"
    )
    assert (program.name, program.source, program.axes) == ("t", "a b.task", 6)
    assert program.capabilities == ("LIN", "PTP")
    assert program.frames[0].pose == (1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0)
    assert program.tools[0].pose is None
    assert program.procedures[0].code[0] == Step("PUSH", (Constant(Type.INT, 4),))


def test_labels_become_indices() -> None:
    code = assemble(in_main("NOP", "again:", "NOP", "JMP again")).procedures[0].code
    assert code[2] == Step("JMP", (1,))


def test_lines_are_a_side_table() -> None:
    procedure = assemble(in_main("NOP", "LINE 7", "NOP", "LINE 0", "HALT")).procedures[0]
    assert procedure.lines == (0, 7, 0)
    assert len(procedure.code) == 3


def test_quoted_names_and_escapes_are_understood() -> None:
    program = assemble(
        HEADER + 'PROC "pick \\"up\\" \\u00e4\\U0001f600"\n  PUSH STR "a;b\\n"\n  MSG\n  RET\nEND\n'
    )
    assert program.procedures[0].name == 'pick "up" ä😀'
    assert program.procedures[0].code[0].operands == (Constant(Type.STR, "a;b\n"),)


def test_a_semicolon_inside_quotes_is_no_comment() -> None:
    assert found(in_main('PUSH STR ";"', "MSG", "HALT")) == []


def test_every_kind_of_line_end_is_understood() -> None:
    text = in_main("NOP", "HALT")
    assert assemble(text.replace("\n", "\r\n")) == assemble(text) == assemble(text.replace("\n", "\r"))


def test_each_wrong_line_gets_its_own_diagnostic_in_order() -> None:
    text = in_main("MOV.LIN", "PUSH INT x", "GETC", "HALT")
    assert found(text) == [("I412", 3, 3), ("I402", 4, 3), ("I414", 5, 3)]


def test_an_unknown_mnemonic_lists_near_names() -> None:
    _, diagnostics = read_text(in_main("MOVE.LYN", "HALT"))
    assert "`MOVE.LIN`" in diagnostics[0].hint


def test_a_missing_label_suggests_a_near_one() -> None:
    _, diagnostics = read_text(in_main("again:", "JMP agian"))
    assert (diagnostics[0].code, diagnostics[0].hint) == ("I413", "did you mean `again`?")


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "I410"),
        ("PROC main\n  HALT\nEND\n", "I410"),
        ("ICR 2.0 t\n", "I410"),
        (HEADER + HEADER, "I401"),
        (HEADER + "PROC main\n  HALT\n", "I401"),
        (HEADER + "END\n", "I401"),
        (HEADER + "NOP\n", "I401"),
        (HEADER + "VAR x NUMBER\n", "I401"),
        (HEADER + "VAR 1x INT\n", "I401"),
        (HEADER + "IO DI a REAL\n", "I401"),
        (HEADER + "FRAMEDEF f 1 2 3\n", "I401"),
        (HEADER + "TOOLDEF f 1 2 3 1 0 0 x\n", "I401"),
        (HEADER + "REQUIRE CAP\n", "I401"),
        (HEADER + "REQUIRE AXES six\n", "I401"),
        (HEADER + "VAR x INT\nVAR x REAL\n", "I403"),
        (HEADER + 'SOURCE "a"\nSOURCE "b"\n', "I403"),
        (HEADER + "PROC a\n  RET\nEND\nPROC a\n  RET\nEND\n", "I403"),
        (HEADER + "PROC a\nLOCAL x INT\nPARAM x INT\n  RET\nEND\n", "I403"),
        (in_main("a:", "a:", "HALT"), "I403"),
        (in_main("1a:", "HALT"), "I401"),
        (in_main("NOP", "LOCAL x INT", "HALT"), "I401"),
        (in_main("LINE -1", "HALT"), "I401"),
        (in_main("VAR x INT", "HALT"), "I401"),
        (in_main('PUSH STR "a', "HALT"), "I402"),
        (in_main('PUSH STR "\\q"', "HALT"), "I402"),
        (in_main("PUSH REAL 1_0", "HALT"), "I402"),
        (in_main("PUSH REAL ١", "HALT"), "I402"),
        (in_main("PUSH INT 9223372036854775808", "HALT"), "I402"),
        (in_main("PUSH INT " + "9" * 5000, "HALT"), "I402"),
        (in_main("PUSH BOOL true", "HALT"), "I402"),
        (in_main("PUSH VEC 1 2", "HALT"), "I402"),
        (in_main("PUSH JOINTS", "HALT"), "I402"),
        (in_main("GRIP shut t", "HALT"), "I414"),
        (in_main("HALT now"), "I414"),
        (in_main('"HALT"', "HALT"), "I401"),
        (in_main("\x00\x07", "HALT"), "I412"),
    ],
)
def test_a_wrong_record_is_refused_with_its_code(text: str, code: str) -> None:
    assert [one[0] for one in found(text)] == [code]


def test_reading_stops_after_many_faults() -> None:
    diagnostics = found(HEADER + "rubbish\n" * 10_000)
    assert len(diagnostics) == 201
    assert diagnostics[-1][0] == "I404"


def test_assemble_raises_with_all_diagnostics() -> None:
    with pytest.raises(AssemblyError, match="I412") as caught:
        assemble(in_main("MOV", "LAOD x", "HALT"))
    assert len(caught.value.diagnostics) == 2
    assert caught.value.diagnostic == caught.value.diagnostics[0]


def test_a_hyphen_is_no_tool_and_a_quoted_one_is() -> None:
    text = 'ICR 1.0 t\nTOOLDEF "-"\nPROC main\n  TOOL -\n  TOOL "-"\n  HALT\nEND\n'
    code = assemble(text).procedures[0].code
    assert (code[0].operands, code[1].operands) == (("",), ("-",))
    assert disassemble(assemble(text)) == text


def test_a_line_without_end_is_refused_at_once() -> None:
    assert found(HEADER + "a " * 600_000) == [("I401", 2, 1)]


def test_a_pose_may_carry_values_of_external_axes() -> None:
    program = assemble(in_main("PUSH POSE 1 2 3 1 0 0 0 EXT 4 5", "POP", "HALT"))
    (constant,) = program.procedures[0].code[0].operands
    assert constant == Constant(Type.POSE, (1.0, 2.0, 3.0, 1.0, 0.0, 0.0, 0.0, 4.0, 5.0))
    assert "PUSH POSE 1.0 2.0 3.0 1.0 0.0 0.0 0.0 EXT 4.0 5.0" in disassemble(program)


@pytest.mark.parametrize(
    "value",
    [
        "1 2 3 1 0 0 0 4",
        "1 2 3 1 0 0 0 EXT",
        "1 2 3 1 0 0 EXT 0",
        "1 2 3 1 0 0 0 EXT x",
        "1 2 3 1 0 0 0 EXT" + 13 * " 1",
        '1 2 3 1 0 0 0 "EXT" 4',
    ],
)
def test_external_values_stand_behind_their_word_and_are_twelve_at_most(value: str) -> None:
    assert found(in_main(f"PUSH POSE {value}", "POP", "HALT")) == [("I402", 3, 3)]
