"""Kinds of diagnostics about the forms of ICR (I401 to I409) and its static rules V1 to V9 (I410 to I449)."""

from ropsim.core import Severity, define

_ERROR = Severity.ERROR

RECORD_MALFORMED = define(
    "I401",
    "icr-record-malformed",
    _ERROR,
    "a line of ICR text cannot be read",
    """
Every line of ICR text is one record: a declaration, a label, or an instruction with its operands. The head
word of this line is known, but what follows does not fit it, or the record stands in the wrong place.

Write it in the form that the hint shows, for example `VAR i INT`.
""",
)
LITERAL_MALFORMED = define(
    "I402",
    "icr-literal-malformed",
    _ERROR,
    "a constant in ICR text cannot be read",
    """
A constant is written as its type and its value: `BOOL TRUE`, `INT 4`, `REAL 0.3`, `STR "text"`, `VEC x y z`,
`ORI w x y z`, `POSE x y z qw qx qy qz`, `JOINTS q1 q2 ...`. INT has 64 bits. Texts stand in double quotes
with the escapes `\\n \\t \\" \\\\ \\uXXXX \\UXXXXXXXX`.
""",
)
NAME_TWICE = define(
    "I403",
    "icr-name-twice",
    _ERROR,
    "a name is declared twice",
    """
Variables, channels, frames, tools, procedures and labels each need different names; otherwise it would not be
certain what an instruction means. A local may have the name of a global variable and hides it.
""",
)
TOO_MANY_FAULTS = define(
    "I404",
    "icr-text-abandoned",
    _ERROR,
    "reading stopped after many faults",
    """
The text has so many wrong lines that it is probably no ICR program. Reading stopped; the lines below were not
looked at. Check that the right file was given.
""",
)
BINARY_DAMAGED = define(
    "I405",
    "icr-binary-damaged",
    _ERROR,
    "a file is no binary ICR program, or is damaged",
    """
Binary ICR begins with the four bytes `ICB` and 0 and ends with the SHA-256 of all bytes before. Where one bit
has changed on the way, where the file is cut short, or where a number in it leads nowhere, nothing of it is
taken. Get the file again, or make it anew with `ropsim icr asm`.
""",
)
BINARY_OTHER_FORM = define(
    "I406",
    "icr-binary-other-form",
    _ERROR,
    "binary ICR that is not written in its one form",
    """
A program has one binary form, so that equal programs have equal files: numbers in as few bytes as they need,
sections in their order and only where they say something, each name once. This file says a program in another
way. Make it anew with `ropsim icr asm`.
""",
)
NAME_TOO_LONG = define(
    "I407",
    "icr-name-too-long",
    _ERROR,
    "a name is too long for the binary form",
    """
Names of variables, channels, frames, tools, procedures and postures have at most 255 bytes in binary ICR.
""",
)
HEADER_WRONG = define(
    "I410",
    "icr-header-wrong",
    _ERROR,
    "V1: the header is missing or names another version",
    """
Rule V1. An ICR text begins with `ICR 1.0 name`: language version and program name. A text of another
version may mean something else by the same words, so it is refused.
""",
)
MAIN_MISSING = define(
    "I411",
    "icr-main-missing",
    _ERROR,
    "V1: there is no procedure `main` without parameters and results",
    """
Rule V1. A program starts in the procedure `main`, which takes no parameters and returns no results.
Add `PROC main`, or take its `PARAM` and `RESULT` records away.
""",
)
OPCODE_UNKNOWN = define(
    "I412",
    "icr-opcode-unknown",
    _ERROR,
    "V2: an instruction is not in the set of ICR 1.0",
    """
Rule V2. Only instructions of the released set may occur, because every port must carry out a program in the
same way. The message lists near names; the whole set with stack effects is in the reference.
""",
)
NAME_UNDECLARED = define(
    "I413",
    "icr-name-undeclared",
    _ERROR,
    "V3: an operand names something that is not declared",
    """
Rule V3. Variables, channels, frames, tools, procedures and labels must be declared in the program: `VAR`,
`LOCAL`, `PARAM`, `IO`, `FRAMEDEF`, `TOOLDEF`, `PROC`, `label:`. `TOOL -` and `FRAME -` stand for the bare
mechanical interface and the base frame.
""",
)
OPERAND_WRONG = define(
    "I414",
    "icr-operand-wrong",
    _ERROR,
    "V3: an operand has the wrong form or is out of range",
    """
Rule V3. Each instruction has a fixed number of operands of fixed kinds, for example `GETC 0`, `STOP 1`,
`GRIP open jaws`. Component indices start with 0. `OUT` needs a channel of kind `DO` or `AO`, `WAIT.IN` one of
type BOOL.
""",
)
STACK_TYPE_WRONG = define(
    "I415",
    "icr-stack-type-wrong",
    _ERROR,
    "V4: an instruction finds a value of the wrong type on the stack",
    """
Rule V4. The types on the stack are known before the program runs. INT and REAL are different types: convert
with `I2R`, `TRUNC` or `ROUND`.
""",
)
STACK_TOO_SHORT = define(
    "I416",
    "icr-stack-too-short",
    _ERROR,
    "V4: an instruction takes more values than the stack holds",
    """
Rule V4. A procedure starts with an empty stack of its own and can never take more than it has put there.
Push the missing operand before this instruction.
""",
)
JOIN_DIFFERS = define(
    "I417",
    "icr-join-differs",
    _ERROR,
    "V4: two ways to one instruction leave different stacks or saved modal states",
    """
Rule V4. Wherever ways join (a label that is jumped to), each must bring the same types on the stack and the
same number of saved modal states. Otherwise the stack could grow without end.
""",
)
RESULTS_DIFFER = define(
    "I418",
    "icr-results-differ",
    _ERROR,
    "V4: RET leaves other values than the procedure declares",
    """
Rule V4. At `RET` the stack of the procedure holds exactly its declared results, in the order of the `RESULT`
records. Take superfluous values away with `POP`.
""",
)
MODAL_UNBALANCED = define(
    "I419",
    "icr-modal-unbalanced",
    _ERROR,
    "V4: MODAL.SAVE and MODAL.RESTORE do not match",
    """
Rule V4. `MODAL.RESTORE` needs a `MODAL.SAVE` before it in the same procedure, and at `RET` everything saved
has been restored. (At `HALT` anything may be left.)
""",
)
FALLS_OFF_END = define(
    "I420",
    "icr-falls-off-end",
    _ERROR,
    "V5: control runs past the last instruction of a procedure",
    """
Rule V5. Every way through a procedure ends with `RET`, `HALT`, `TRAP`, `STOP` or a jump back. Add the
missing one.
""",
)
CODE_UNREACHABLE = define(
    "I421",
    "icr-code-unreachable",
    _ERROR,
    "V5: an instruction can never be reached",
    """
Rule V5. Code that no way leads to is a sign of a damaged or wrongly generated program, so it is refused.
Remove it, or mend the jump that should lead there.
""",
)
CALLS_CYCLIC = define(
    "I422",
    "icr-calls-cyclic",
    _ERROR,
    "V6: a procedure calls itself, directly or through others",
    """
Rule V6. Calls must not form a cycle. So the depth of the stack is bounded and known before the program runs.
Use a loop instead of recursion.
""",
)
NOT_ASSIGNED = define(
    "I423",
    "icr-not-assigned",
    _ERROR,
    "V7: a variable may be read before it has a value",
    """
Rule V7. On every way from the start to a `LOAD` there is a `STORE` of the same variable. Parameters have a
value from the start; global variables may get theirs in the caller.
""",
)
NOT_FINITE = define(
    "I424",
    "icr-literal-not-finite",
    _ERROR,
    "V8: a constant is infinite or not a number",
    """
Rule V8. REAL values are always finite; `inf` and `nan` cannot be lengths, angles or times.
""",
)
NOT_UNIT_QUATERNION = define(
    "I425",
    "icr-quaternion-not-unit",
    _ERROR,
    "V8: a quaternion has not length 1, or w < 0",
    """
Rule V8. Orientations are unit quaternions (w, x, y, z) with w >= 0, so that one orientation has one
spelling and one hash. Divide the four numbers by the root of the sum of their squares, and change all signs
where w < 0.
""",
)
SPEED_NOT_POSITIVE = define(
    "I426",
    "icr-speed-not-positive",
    _ERROR,
    "V8: a constant speed, acceleration, angle or zone is out of range",
    """
Rule V8. Speeds, accelerations and jerks are greater than 0; shares (`SPD.PTP`, `ACC.PTP`) lie in (0, 1];
the angle of an arc is greater than 0; zones and waiting times are at least 0. Values that are computed are
checked when the program runs.
""",
)
CAPABILITIES_DIFFER = define(
    "I427",
    "icr-capabilities-differ",
    _ERROR,
    "V9: REQUIRE CAP does not list what the program uses",
    """
Rule V9. A reader of the header must be able to trust it: `REQUIRE CAP` lists exactly the capabilities of the
instructions that occur (`CIRC CLOCK CONFIG EXT FREE GRIP GUARD IO JNT LIN MSG POSE PTP SPLINE TRACK TRIG
ZONE`). `EXT` is needed by a constant pose with values of external axes, too.
""",
)
AXES_DIFFER = define(
    "I428",
    "icr-axes-differ",
    _ERROR,
    "V9: REQUIRE AXES does not agree with the joint coordinates in the program",
    """
Rule V9. All JOINTS values of a program have one coordinate for each axis of the arm. `REQUIRE AXES n`
declares how many (1 to 32), and every `MKJ n`, `PUSH JOINTS` and component index must agree with it.
""",
)
PREFIX_LOST = define(
    "I429",
    "icr-prefix-without-move",
    _ERROR,
    "V4: an instruction that belongs to the next move is not followed by one",
    """
Rule V4. `TRIG.DIST`, `TRIG.TIME`, `GUARD` and `TRACK` say something about the next move. On every way a move
must follow before the procedure ends or calls another one, and before any other instruction goes to the
robot. Between them may stand what only computes, modal instructions and further ones that belong to the same
move, `GUARD` and `TRACK` once each. After `TRACK` the move must have a path of the tool.
""",
)
