"""The opcode table of ICR 1.0: the one source of reader, printer, verifier and machine.

A code is class · 256 + number. Codes are frozen once released and never used again. Classes: 00 control,
01 data, 02 arithmetic, 03 flow, 04 geometry, 05 modal state, 06 motion, 07 inputs, outputs and time,
08 conditions and poses of the arm.
"""

import re
from enum import Enum

from ropsim.core import frozen_dataclass
from ropsim.icr.types import Type


class OperandKind(Enum):
    """Kind of entity that an operand names."""

    CONSTANT = "constant"
    VARIABLE = "variable"
    LABEL = "label"
    PROCEDURE = "procedure"
    FRAME = "frame"
    TOOL = "tool"
    CHANNEL = "channel"
    COUNT = "count"
    INDEX = "index"
    NUMBER = "number"
    ACTION = "action"
    CATEGORY = "category"
    SIDE = "side"
    COMPARISON = "comparison"
    POSTURE = "posture"
    DIRECTION = "direction"
    LIST = "list"

    __hash__ = object.__hash__
    """Each kind is one object, as each `Type` is."""


POSTURE = re.compile(r"[a-z][a-z0-9_]*(?:-[a-z][a-z0-9_]*)*\Z")
"""Words of a posture with dashes between, as postures are named."""

WORDS = {
    OperandKind.ACTION: ("open", "close"),
    OperandKind.SIDE: ("before", "after"),
    OperandKind.COMPARISON: ("is", "above", "below"),
    OperandKind.DIRECTION: ("x", "y", "z", "-x", "-y", "-z"),
}
"""Operands that are one of a few words."""


@frozen_dataclass
class Opcode:
    """One instruction of the set.

    Attributes:
        code: number, class · 256 + op.
        mnemonic: word of the text form.
        operands: kinds of the operands.
        pops: types taken from the stack, the top last; None = depends on the operand or on the stack.
        pushes: types left there; None also if it depends on the operand.
        meaning: one line.
        capability: required capability of a robot, or empty.
    """

    code: int
    mnemonic: str
    operands: tuple[OperandKind, ...]
    pops: tuple[Type, ...] | None
    pushes: tuple[Type, ...] | None
    meaning: str
    capability: str = ""

    @property
    def ends_flow(self) -> bool:
        """Return whether control never reaches the next instruction."""
        return self.mnemonic in ENDS_FLOW

    @property
    def is_move(self) -> bool:
        """Return whether the robot is commanded to move."""
        return self.mnemonic.startswith("MOVE.") or self.mnemonic == "HOME"


ENDS_FLOW = frozenset({"HALT", "TRAP", "JMP", "RET", "STOP"})
"""Instructions behind which control never reaches the next one."""
_LETTERS = {
    "B": Type.BOOL,
    "I": Type.INT,
    "R": Type.REAL,
    "S": Type.STR,
    "V": Type.VEC,
    "O": Type.ORI,
    "P": Type.POSE,
    "J": Type.JOINTS,
}

# code mnemonic operands pops pushes capability meaning; "-" = none, "*" = see the meaning
_TABLE = """
0000 NOP       -        -   -  -     do nothing
0001 HALT      -        -   -  -     end the program
0003 TRAP      number   -   -  -     end the program with trap n (1 = timed out, 2 = not a whole number)
0101 PUSH      constant -   *  -     push a constant
0102 LOAD      variable -   *  -     push the value of a variable
0103 STORE     variable *   -  -     take the value of a variable from the stack
0107 DUP       -        *   *  -     [a -> a a]
0108 POP       -        *   -  -     [a ->]
0109 SWAP      -        *   *  -     [a b -> b a]
0201 ADD.I     -        II  I  -     sum
0202 SUB.I     -        II  I  -     difference
0203 MUL.I     -        II  I  -     product
0204 DIV.I     -        II  I  -     quotient rounded down; a = b·DIV + MOD
0205 MOD.I     -        II  I  -     remainder with the sign of the divisor
0206 NEG.I     -        I   I  -     opposite
0207 ABS.I     -        I   I  -     absolute value
0208 MIN.I     -        II  I  -     the smaller one
0209 MAX.I     -        II  I  -     the larger one
0211 ADD.R     -        RR  R  -     sum
0212 SUB.R     -        RR  R  -     difference
0213 MUL.R     -        RR  R  -     product
0214 DIV.R     -        RR  R  -     quotient
0215 MOD.R     -        RR  R  -     remainder with the sign of the divisor
0216 NEG.R     -        R   R  -     opposite
0217 ABS.R     -        R   R  -     absolute value
0218 MIN.R     -        RR  R  -     the smaller one
0219 MAX.R     -        RR  R  -     the larger one
0221 ADD.V     -        VV  V  -     vector sum
0222 SUB.V     -        VV  V  -     vector difference
0231 POW       -        RR  R  -     [base exponent -> power]
0232 SQRT      -        R   R  -     square root
0233 SIN       -        R   R  -     sine of an angle [rad]
0234 COS       -        R   R  -     cosine of an angle [rad]
0235 TAN       -        R   R  -     tangent of an angle [rad]
0236 ASIN      -        R   R  -     arc sine [rad]
0237 ACOS      -        R   R  -     arc cosine [rad]
0238 ATAN2     -        RR  R  -     [y x -> angle of the point (x, y)] [rad]
0239 I2R       -        I   R  -     integer to real
023A TRUNC     -        R   I  -     real to integer towards zero
023B ROUND     -        R   I  -     real to the nearest integer, halves away from zero
0241 EQ.I      -        II  B  -     equal
0242 NE.I      -        II  B  -     not equal
0243 LT.I      -        II  B  -     less
0244 LE.I      -        II  B  -     less or equal
0245 GT.I      -        II  B  -     greater
0246 GE.I      -        II  B  -     greater or equal
0251 EQ.R      -        RR  B  -     equal
0252 NE.R      -        RR  B  -     not equal
0253 LT.R      -        RR  B  -     less
0254 LE.R      -        RR  B  -     less or equal
0255 GT.R      -        RR  B  -     greater
0256 GE.R      -        RR  B  -     greater or equal
0261 EQ.B      -        BB  B  -     equal
0271 NOT       -        B   B  -     negation
0272 AND       -        BB  B  -     conjunction; both operands are evaluated
0273 OR        -        BB  B  -     disjunction; both operands are evaluated
0274 XOR       -        BB  B  -     one but not both
0301 JMP       label    -   -  -     go to a label
0302 JF        label    B   -  -     go to a label if false
0303 JT        label    B   -  -     go to a label if true
0304 CALL      procedure *  *  -     run a procedure: parameters from the stack, results on it
0305 RET       -        *   *  -     leave the procedure with its results
0401 MKVEC     -        RRR V  -     [x y z -> vector]
0402 MKORI.ZYX -        RRR O  -     [c b a -> Rz(c)·Ry(b)·Rx(a)] [rad]
0403 MKORI.Q   -        RRRR O -     [w x y z -> orientation], made a unit quaternion
0404 MKPOSE    -        VO  P  -     [position orientation -> pose]
0405 MKJ       count    *   J  -     joint coordinates of n reals
0407 COMPOSE   -        PP  P  -     [X_AB X_BC -> X_AC], external values and frame of X_AB, else X_BC
0408 INV       -        P   P  -     [X_AB -> X_BA], without external values and frame
040A GETPOS    -        P   V  -     position of a pose
040B GETORI    -        P   O  -     orientation of a pose
040C DIST      -        PP  R  -     distance of the origins of two poses [m]
040D ANGLE     -        PP  R  -     angle between the orientations of two poses [rad], 0 .. pi
040E CURPOSE   -        -   P  -     command pose behind the last move, X_KT, for frame and tool in force
0410 INFRAME   frame    P   P  -     [pose -> the same numbers in a task frame of its own]; - for none
0411 REFRAME   -        PP  P  -     [X_AB X_BC -> X_AC]; X_BC as it is where it has a task frame of its own
0412 GETC      index    *   R  -     component i of a POSE, VEC, ORI or JOINTS: x y z, rx ry rz (fixed XYZ)
0413 SETC      index    *   *  -     [value real -> value with component i replaced]
0414 MKEXT     count    *  P  EXT   [pose e1 .. en -> pose with n values of external axes]
0415 POSTURE   posture  P   P  CONFIG [pose -> pose to be reached in a posture]; words of it with - between
0416 TURNS     count    *   P  CONFIG [pose k1 .. kn -> pose with the turns of the first n axes]
0417 AXES      -        PO  P  -     [pose axes -> the same place, shifted along these axes of the task frame]
0418 OFFSET    -        PV  P  -     [pose way -> pose shifted along its axes, else those of its task frame]
0419 ITEM      list     I   P  -     [i -> pose i of a list, counted from 1]
041A ORI.FREE  -        P   P  FREE  [pose -> pose of which the position counts, its orientation is free]
0501 FRAME     frame    -   -  -     task frame in force
0503 TOOL      tool     -   -  -     tool in force
0506 SPD.PTP   -        R   -  -     share of the joint speed limits, (0, 1]
0507 SPD.LIN   -        R   -  -     speed of the TCP on lines [m/s]
0508 SPD.ORI   -        R   -  -     angular speed limit on lines [rad/s]
050A ACC.PTP   -        R   -  -     share of the joint acceleration limits, (0, 1]
050B ACC.LIN   -        R   -  -     acceleration of the TCP on lines [m/s2]
050C ACC.ORI   -        R   -  -     angular acceleration limit on lines [rad/s2]
050D JERK      -        R   -  -     jerk of the TCP on lines [m/s3]
050E ZONE.FINE -        -   -  ZONE  stop at the target
050F ZONE.DIST -        R   -  ZONE  distance from the target at which the next move may begin [m]
0510 ZONE.VIA  -        -   -  ZONE  pass by; without a zone at the distance that the cell has for via points
0520 MODAL.SAVE -       -   -  -     save the whole modal state
0521 MODAL.RESTORE -    -   -  -     bring back the modal state saved last
0601 MOVE.PTP.J -       J   -  JNT   pose-to-pose move to joint coordinates
0602 MOVE.PTP  -        P   -  PTP   pose-to-pose move to a pose in the task frame
0603 MOVE.LIN  -        P   -  LIN   straight move to a pose in the task frame
0604 MOVE.CIRC -        PP  -  CIRC  [via to] arc of a circle through a pose to a pose in the task frame
0605 MOVE.SPL  count    *   -  SPLINE smooth curve through n poses in the task frame, the last one its target
0608 HOME      -        -   -  PTP   pose-to-pose move to the home position of the arm
0609 SYNC      -        -   -  -     wait until everything before has been carried out
060A STOP      category -   -  -     end the program by a stop of category 0, 1 or 2 (IEC 60204-1)
060B TRIG.DIST side,channel * - TRIG [value distance ->] output on the next move at a way of the TCP [m]
060C TRIG.TIME side,channel * - TRIG [value time ->] output on the next move at a time [s]
060D MOVE.CIRC.A -      PPR -  CIRC  [via to angle] arc of an angle [rad] on the circle through two poses
060E MOVE.SPL.L list    PP  -  SPLINE [X_AB X_CD ->] curve through X_AB·X_BC·X_CD of all poses X_BC of a list
0701 IN        channel  -   *  IO    value of a channel
0702 OUT       channel  *   -  IO    set an output channel
0704 WAIT.T    -        R   -  -     stand still for a time [s]
0705 WAIT.IN   channel  BR  B  IO    [value timeout -> whether it came in time]; timeout <= 0 waits for ever
0706 TIME      -        -   R  CLOCK time since the start [s]
0707 MSG       -        S   -  MSG   show a text to the operator
0709 GRIP      action,tool - - GRIP  open or close the gripper of a tool
070A FMT       -        *   S  -     any value as text
070B CAT       -        SS  S  -     one text after the other
0804 GUARD     comparison,channel * - GUARD [value timeout ->] condition that ends the next move
0805 TRACK     direction,channel RR - TRACK [value gain ->] path of the next move is shifted by a sensor
0809 MET       -        -   B  GUARD whether the condition of the guarded move before came true
080A ATTAINED  -        -   P  POSE  pose that the tool in force has, X_KT, in the frame in force
"""


def _types(letters: str) -> tuple[Type, ...] | None:
    if letters == "*":
        return None
    return () if letters == "-" else tuple(_LETTERS[letter] for letter in letters)


def _row(line: str) -> Opcode:
    code, mnemonic, operands, pops, pushes, capability, meaning = line.split(maxsplit=6)
    kinds = () if operands == "-" else tuple(OperandKind(kind) for kind in operands.split(","))
    return Opcode(
        int(code, 16),
        mnemonic,
        kinds,
        _types(pops),
        _types(pushes),
        meaning,
        "" if capability == "-" else capability,
    )


OPCODES = {opcode.mnemonic: opcode for opcode in map(_row, _TABLE.strip().splitlines())}
"""Mnemonic -> opcode, in the order of the codes."""
