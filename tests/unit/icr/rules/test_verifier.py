import math
from dataclasses import replace

import pytest

from ropsim.icr import AssemblyError, Constant, IoChannel, Procedure, Program, Step, Type, assemble, verify

VALID = """ICR 1.0 t
REQUIRE AXES 2
REQUIRE CAP IO JNT LIN PTP ZONE
VAR g INT
VAR ready BOOL
IO DI part BOOL
IO AI force REAL
IO DO valve BOOL
FRAMEDEF f 0.0 0.0 0.0 1.0 0.0 0.0 0.0
TOOLDEF t 0.0 0.0 0.1 1.0 0.0 0.0 0.0
PROC main
LOCAL k INT
  FRAME f
  TOOL t
  PUSH REAL 0.5
  SPD.PTP
  ZONE.FINE
  PUSH INT 3
  STORE g
  PUSH INT 0
  STORE k
L0:
  LOAD k
  LOAD g
  LT.I
  JF L1
  LOAD k
  CALL square
  STORE k
  MODAL.SAVE
  PUSH REAL 0.1
  SPD.LIN
  PUSH POSE 0.1 0.2 0.3 1.0 0.0 0.0 0.0
  DUP
  GETC 0
  POP
  MOVE.LIN
  MODAL.RESTORE
  LOAD k
  PUSH INT 1
  ADD.I
  STORE k
  JMP L0
L1:
  PUSH REAL 0.1
  PUSH REAL 0.2
  MKJ 2
  MOVE.PTP.J
  PUSH BOOL TRUE
  OUT valve
  HOME
  SYNC
  HALT
END
PROC square
PARAM n INT
RESULT INT
  LOAD n
  LOAD n
  MUL.I
  RET
END
"""


def codes(text: str) -> list[str]:
    return [one.code for one in verify(assemble(text, "t.icr"))]


def changed(old: str, new: str) -> str:
    assert VALID.count(old) >= 1
    return VALID.replace(old, new, 1)


def test_a_sound_program_has_no_findings() -> None:
    assert codes(VALID) == []


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        # V1
        ("PROC main", "PROC start", "I411"),
        ("PROC main", "PROC main\nPARAM z INT", "I411"),
        # V3
        ("STORE g\n  PUSH INT 0", "STORE gg\n  PUSH INT 0", "I413"),
        ("CALL square", "CALL sqare", "I413"),
        ("FRAME f", "FRAME h", "I413"),
        ("TOOL t", "TOOL tt", "I413"),
        ("OUT valve", "OUT valv", "I413"),
        ("OUT valve", "OUT part", "I414"),
        ("GETC 0", "GETC 6", "I414"),
        ("GETC 0", "GETC 99", "I414"),
        ("SYNC", "STOP 3", "I414"),
        ("  SYNC\n  HALT", "  PUSH REAL 0.0\n  PUSH REAL 1.0\n  WAIT.IN force\n  POP\n  HALT", "I414"),
        # V4
        ("  MUL.I\n", "  MUL.R\n", "I415"),
        ("  LOAD k\n  CALL square", "  CALL square", "I416"),
        ("  DUP\n  GETC 0", "  GETC 0", "I416"),
        ("  LT.I\n  JF L1", "  LT.I\n  PUSH INT 1\n  SWAP\n  JF L1", "I417"),
        ("  MUL.I\n", "", "I418"),
        ("  MUL.I\n", "  MUL.I\n  MODAL.SAVE\n", "I419"),
        ("  MODAL.SAVE\n", "", "I419"),
        ("  MODAL.RESTORE\n", "", "I417"),
        ("  LOAD n\n  LOAD n", "  SWAP\n  LOAD n\n  LOAD n", "I416"),
        ("  LOAD n\n  LOAD n", "  DUP\n  LOAD n\n  LOAD n", "I416"),
        ("  FRAME f", "  PUSH INT 1\n  GETC 0\n  POP\n  FRAME f", "I415"),
        ("  FRAME f", "  PUSH REAL 1.0\n  SETC 0\n  POP\n  FRAME f", "I416"),
        ("  FRAME f", "  FMT\n  POP\n  FRAME f", "I416"),
        # V5
        ("  MUL.I\n  RET", "  MUL.I\n  POP", "I420"),
        ("  LOAD n\n  LOAD n\n  MUL.I\n  RET\n", "", "I420"),
        ("  SYNC\n  HALT", "  HALT\n  SYNC\n  HALT", "I421"),
        ("  SYNC\n  HALT\n", "  JMP L2\nL2:\n", "I420"),
        # V6
        ("  LOAD n\n  LOAD n", "  LOAD n\n  CALL square\n  LOAD n", "I422"),
        # V7
        ("  PUSH INT 3\n  STORE g\n", "", "I423"),
        ("  PUSH INT 0\n  STORE k\n", "", "I423"),
        # V8
        ("PUSH REAL 0.1\n  SPD.LIN", "PUSH REAL 0.0\n  SPD.LIN", "I426"),
        ("PUSH REAL 0.5", "PUSH REAL 1.5", "I426"),
        ("PUSH REAL 0.5", "PUSH REAL nan", "I424"),
        ("TOOLDEF t 0.0", "TOOLDEF t inf", "I424"),
        ("FRAMEDEF f 0.0 0.0 0.0 1.0", "FRAMEDEF f 0.0 0.0 0.0 0.9", "I425"),
        ("0.3 1.0 0.0 0.0 0.0", "0.3 -1.0 0.0 0.0 0.0", "I425"),
        # V9
        ("REQUIRE CAP IO JNT LIN PTP ZONE", "REQUIRE CAP IO JNT LIN PTP", "I427"),
        ("REQUIRE CAP IO", "REQUIRE CAP GRIP IO", "I427"),
        ("  MOVE.LIN\n", "  DUP\n  MOVE.CIRC\n", "I427"),
        ("REQUIRE AXES 2", "REQUIRE AXES 6", "I428"),
        ("REQUIRE AXES 2\n", "", "I428"),
        ("REQUIRE AXES 2\n", "REQUIRE AXES 99\n", "I428"),
    ],
)
def test_a_rule_refuses_what_breaks_it(old: str, new: str, code: str) -> None:
    found = codes(changed(old, new))
    assert found
    assert set(found) == {code}


@pytest.mark.parametrize(
    ("path", "code"),
    [
        ("MOVE.CIRC", "I416"),
        ("PUSH REAL 0.5\n  MOVE.SPL 2", "I415"),
        ("MOVE.SPL 0", "I414"),
        ("TURNS 33\n  MOVE.LIN", "I414"),
        ("PUSH REAL 1.0\n  TURNS 1\n  MOVE.LIN", "I415"),
        ("MOVE.SPL 1001", "I414"),
        ("DUP\n  PUSH REAL -1.0\n  MOVE.CIRC.A", "I426"),
    ],
)
def test_a_path_needs_its_points_and_an_angle_in_range(path: str, code: str) -> None:
    assert code in codes(changed("  MOVE.LIN\n", f"  {path}\n"))


GUARD = "PUSH REAL 1.0\n  PUSH REAL 0.0\n  GUARD above force\n  "
TRIGGER = "  PUSH BOOL TRUE\n  PUSH REAL 0.1\n  TRIG.DIST after valve\n"


@pytest.mark.parametrize(
    "between",
    [
        "CALL square",
        "RET",
        "HALT",
        "STOP 1",
        "SYNC",
        "PUSH BOOL TRUE\n  OUT valve",
        "PUSH REAL 1.0\n  WAIT.T",
        "PUSH BOOL TRUE\n  PUSH REAL 1.0\n  WAIT.IN part",
        'PUSH STR "a"\n  MSG',
        "GRIP open -",
    ],
)
def test_nothing_of_the_robot_stands_between_a_trigger_and_its_move(between: str) -> None:
    assert "I429" in codes(changed("  HOME\n", f"{TRIGGER}  {between}\n  HOME\n"))


def test_what_only_computes_stands_between_a_trigger_and_its_move() -> None:
    rest = "  PUSH REAL 0.2\n  SPD.PTP\n  IN part\n  POP\n  MODAL.SAVE\n  MODAL.RESTORE\n"
    text = changed("  HOME\n", f"{TRIGGER}{rest}{TRIGGER}  HOME\n")
    assert codes(text.replace("PTP ZONE", "PTP TRIG ZONE")) == []


def test_a_trigger_is_followed_by_a_move_on_every_way() -> None:
    branch = "  IN part\n  JF over\n  HOME\n  JMP done\nover:\n{}done:\n"
    for way, found in (("  HOME\n", set()), ("  NOP\n", {"I417", "I429"}), ("  HALT\n", {"I429"})):
        text = changed("  HOME\n", TRIGGER + branch.format(way))
        assert set(codes(text.replace("PTP ZONE", "PTP TRIG ZONE"))) == found


@pytest.mark.parametrize(
    ("guard", "code"),
    [
        ("PUSH REAL 1.0\n  PUSH REAL 1.0\n  GUARD is part", "I415"),
        ("PUSH BOOL TRUE\n  PUSH REAL 1.0\n  GUARD above part", "I414"),
        ("PUSH REAL 1.0\n  PUSH REAL 1.0\n  GUARD is force", "I414"),
        ("PUSH REAL 1.0\n  PUSH REAL 1.0\n  GUARD below forc", "I413"),
        (GUARD + GUARD, "I429"),
        (GUARD + "HALT", "I429"),
        (GUARD, ""),
        (GUARD + TRIGGER.strip(), ""),
    ],
)
def test_a_guard_compares_one_channel_and_is_the_only_one_of_its_move(guard: str, code: str) -> None:
    text = changed("  HOME\n", f"  {guard.strip()}\n  HOME\n")
    names = "GUARD IO JNT LIN PTP TRIG ZONE" if "TRIG" in guard else "GUARD IO JNT LIN PTP ZONE"
    found = set(codes(text.replace("IO JNT LIN PTP ZONE", names)))
    assert code in found if code else not found


TRACK = "PUSH REAL 1.0\n  PUSH REAL 10.0\n  TRACK z force\n  "


@pytest.mark.parametrize(
    ("track", "move", "code"),
    [
        (TRACK, "MOVE.LIN", ""),
        (TRACK.replace(" z ", " -x "), "MOVE.LIN", ""),
        (TRACK + GUARD, "MOVE.LIN", ""),
        (TRACK + TRACK, "MOVE.LIN", "I429"),
        (TRACK, "HOME", "I429"),
        (TRACK + "HALT\n  ", "MOVE.LIN", "I429"),
        (TRACK.replace("10.0", "0.0"), "MOVE.LIN", "I426"),
        (TRACK.replace("force", "part"), "MOVE.LIN", "I414"),
        (TRACK.replace("PUSH REAL 1.0\n  ", ""), "MOVE.LIN", "I415"),
    ],
)
def test_a_correction_names_a_number_and_belongs_to_one_path_of_the_tool(
    track: str, move: str, code: str
) -> None:
    text = changed(f"  {move}\n", f"  {track.strip()}\n  {move}\n")
    names = "GUARD IO JNT LIN PTP TRACK ZONE" if "GUARD" in track else "IO JNT LIN PTP TRACK ZONE"
    found = set(codes(text.replace("IO JNT LIN PTP ZONE", names)))
    assert code in found if code else not found


@pytest.mark.parametrize(
    ("trigger", "code"),
    [
        ("PUSH BOOL TRUE\n  PUSH REAL -0.1\n  TRIG.TIME before valve", "I426"),
        ("PUSH BOOL TRUE\n  PUSH REAL 0.1\n  TRIG.TIME before part", "I414"),
        ("PUSH BOOL TRUE\n  PUSH REAL 0.1\n  TRIG.TIME before valv", "I413"),
        ("PUSH REAL 1.0\n  PUSH REAL 0.1\n  TRIG.DIST after valve", "I415"),
    ],
)
def test_a_trigger_sets_an_output_at_a_place_in_range(trigger: str, code: str) -> None:
    text = changed("  HOME\n", f"  {trigger}\n  HOME\n")
    assert codes(text.replace("PTP ZONE", "PTP TRIG ZONE")) == [code]


@pytest.mark.parametrize("posture", ["", "left-", "-up", "Left", "left up", 3])
def test_a_posture_is_words_with_dashes_between(posture: str | int) -> None:
    program = assemble(VALID)
    main = program.procedures[0]
    at = next(k for k, step in enumerate(main.code) if step.mnemonic == "MOVE.LIN")
    code = (*main.code[:at], Step("POSTURE", (posture,)), *main.code[at:])
    made = replace(main, code=code, lines=(0,) * len(code), places=())
    found = verify(replace(program, procedures=(made, *program.procedures[1:])))
    assert "I414" in [one.code for one in found]


@pytest.mark.parametrize("written", ["left-", '"left"', "Left", ""])
def test_a_posture_that_is_written_otherwise_is_not_read(written: str) -> None:
    with pytest.raises(AssemblyError):
        assemble(changed("  MOVE.LIN\n", f"  POSTURE {written}\n  MOVE.LIN\n"))


def test_a_diagnostic_marks_the_instruction_in_the_text() -> None:
    found = verify(assemble(changed("CALL square", "CALL sqare"), "t.icr"))[0]
    assert str(found.span) == "t.icr:28:3"
    assert found.hint == "did you mean `square`?"


def test_recursion_shows_the_call_chain() -> None:
    text = "ICR 1.0 t\nPROC main\n  CALL a\n  HALT\nEND\n"
    text += "PROC a\n  CALL b\n  RET\nEND\nPROC b\n  CALL a\n  RET\nEND\n"
    found = verify(assemble(text))
    assert [one.message for one in found] == ["`a` calls itself: a -> b -> a"]


def test_int_where_real_is_needed_suggests_the_conversion() -> None:
    found = verify(assemble(changed("PUSH REAL 0.5", "PUSH INT 1")))
    assert [(one.code, one.hint) for one in found] == [("I415", "convert with `I2R`")]


GLOBAL = """ICR 1.0 t
VAR g INT
PROC main
  CALL first
  CALL second
  HALT
END
PROC first
  PUSH INT 1
  STORE g
  RET
END
PROC second
  LOAD g
  POP
  RET
END
"""


def test_a_global_may_get_its_value_in_another_procedure() -> None:
    assert codes(GLOBAL) == []


def test_a_global_read_by_a_callee_must_have_a_value_at_the_call() -> None:
    found = verify(assemble(GLOBAL.replace("  CALL first\n", "  CALL second\n", 1)))
    assert [one.code for one in found] == ["I423"]


def test_a_local_of_the_same_name_does_not_give_the_global_a_value() -> None:
    text = GLOBAL.replace("PROC main\n  CALL first\n", "PROC main\nLOCAL g INT\n  PUSH INT 1\n  STORE g\n")
    assert codes(text) == ["I423"]


def test_a_value_on_one_branch_only_is_not_enough() -> None:
    body = "LOCAL x INT\n  PUSH BOOL TRUE\n  JF L0\n  PUSH INT 1\n  STORE x\nL0:\n  LOAD x\n  POP\n  HALT\n"
    assert codes(f"ICR 1.0 t\nPROC main\n{body}END\n") == ["I423"]


def test_halt_may_leave_saved_modal_states() -> None:
    assert codes("ICR 1.0 t\nPROC main\n  MODAL.SAVE\n  HALT\nEND\n") == []


def in_python(*code: Step, base: Program | None = None) -> list[str]:
    """Return the codes found in a program whose `main` has this code and a HALT."""
    main = Procedure("main", code=(*code, Step("HALT")))
    return [one.code for one in verify(replace(base or Program("t", ()), procedures=(main,)))]


def test_programs_made_in_python_are_checked_as_well() -> None:
    push = Step("PUSH", (Constant(Type.REAL, math.inf),))
    assert in_python(base=Program("t", (), version="2.0")) == ["I410"]
    assert in_python(Step("MOVE.SPIRAL")) == ["I412"]
    assert in_python(Step("JMP", (99,))) == ["I414"]
    assert in_python(Step("JMP", ("L0",))) == ["I414"]
    assert in_python(Step("PUSH", (1,))) == ["I414"]
    assert in_python(Step("PUSH", (Constant(Type.INT, 2**63),)), Step("POP")) == ["I414"]
    assert in_python(Step("PUSH", (Constant(Type.VEC, (1.0,)),)), Step("POP")) == ["I414"]
    assert in_python(push, Step("POP")) == ["I424"]
    assert in_python(Step("NOP", ("x",))) == ["I414"]
    assert in_python(Step("LOAD", (1,))) == ["I414"]
    assert in_python(base=Program("t", (), channels=(IoChannel("a", "XX", Type.BOOL),))) == ["I414"]
    assert in_python(base=Program("t", (), channels=(IoChannel("", "DI", Type.BOOL),))) == ["I413"]
    assert in_python(base=Program("t", (), channels=(IoChannel("a", "DI", Type.BOOL),) * 2)) == ["I403"]


def test_external_values_need_a_robot_that_has_such_axes() -> None:
    head, pose = "ICR 1.0 t\n{}PROC main\n  PUSH POSE 0.0 0.0 0.0 1.0 0.0 0.0 0.0", "  POP\n  HALT\nEND\n"
    for given in (" EXT 1.0\n", "\n  PUSH REAL 1.0\n  MKEXT 1\n"):
        assert [one.code for one in verify(assemble(head.format("") + given + pose))] == ["I427"]
        assert verify(assemble(head.format("REQUIRE CAP EXT\n") + given + pose)) == ()


@pytest.mark.parametrize("count", [0, 13])
def test_a_pose_carries_one_to_twelve_external_values(count: int) -> None:
    pushed = "  PUSH REAL 1.0\n" * count
    text = (
        f"ICR 1.0 t\nREQUIRE CAP EXT\nPROC main\n  PUSH POSE 0 0 0 1 0 0 0\n{pushed}  MKEXT {count}\n  POP\n"
    )
    assert [one.code for one in verify(assemble(f"{text}  HALT\nEND\n"))] == ["I414"]


def test_frames_carry_no_external_values() -> None:
    program = assemble(VALID)
    # what no type allows, and a record made in Python may hold all the same
    longer = replace(program.frames[0], pose=(*program.frames[0].pose, 0.5))  # type: ignore[arg-type]
    assert [one.code for one in verify(replace(program, frames=(longer,)))] == ["I414"]
