"""One sentence on every word of the language, as the manual explains it."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Word:
    """A word, its spelling, and its meaning."""

    form: str
    meaning: str


STATEMENTS: dict[str, Word] = {
    "program": Word("program NAME", "Names the program and makes the text modern: no implicit parameters."),
    "units": Word("units UNIT, …", "Units of bare numbers, for the whole text wherever it stands."),
    "classic": Word("classic", "Turns implicit parameters of tasks on, in any text."),
    "strict": Word("strict", "New variables by `var` only; bare numbers with a dimension are warned about."),
    "frame": Word("frame NAME = pose", "A frame, given in the base frame; upright unless turned."),
    "loc": Word("loc NAME = location", "A fixed location, or joint coordinates with `joints(…)`."),
    "tool": Word("tool NAME = pose", "A tool frame, given in the mechanical interface."),
    "signal": Word("signal NAME = [analog] input|output n", "A channel; the cell binds it by name."),
    "const": Word("const NAME [: type] = value", "A constant, known before the program runs."),
    "var": Word("var NAME [: type] [= value]", "A variable that all tasks see."),
    "pattern": Word("pattern NAME = grid a x b from location step v1, v2", "A grid of locations."),
    "task": Word("task NAME [(parameters)] [-> type] … endp", "A named piece of program with parameters."),
    "needs": Word("needs words", "What the task needs at its start, such as `gripper open`."),
    "assumes": Word("assumes words", "What the task takes for granted, such as `gripper closed`."),
    "end": Word("end", "Alone on a line: end of the innermost block, whichever it is."),
    "endp": Word("endp", "End of a task."),
    "endtask": Word("endtask", "End of a task; the same as `endp`."),
    "mov": Word("mov [via a, … to] target|along LIST", "Pose to pose: all joints start and end together."),
    "movj": Word("movj [to] target", "The same as `mov`."),
    "lin": Word("lin [via a, … to] target|along LIST", "The TCP on a straight line, turned about one axis."),
    "movl": Word("movl [to] target", "The same as `lin`."),
    "circ": Word("circ via a to target [angle a]", "The TCP on an arc of a circle through a point."),
    "movc": Word("movc via a to target", "The same as `circ`."),
    "spline": Word("spline [via] a, … to target|along LIST", "The TCP on a smooth curve through points."),
    "open": Word("open [TOOL]", "Opens the gripper of the tool named, else of the tool in force."),
    "close": Word("close [TOOL]", "Closes the gripper of the tool named, else of the tool in force."),
    "load": Word("load (x, y, z), location", "Copies the coordinates of a location into variables."),
    "set": Word("set OUTPUT on|off|= value", "Sets an output, or a speed, zone, tool or frame from now on."),
    "wait": Word("wait t | until c [timeout t]", "Stands still for a time, or until a condition holds."),
    "if": Word("if c [then] … endif", "Carries out the lines below where the condition holds."),
    "else": Word("else", "The lines below run where no condition above held."),
    "elseif": Word("elseif c", "A further condition of an `if`."),
    "endif": Word("endif", "End of an `if`."),
    "repeat": Word("repeat [n] … endr", "Passes through the lines n times, without n for ever."),
    "endr": Word("endr", "End of a `repeat`."),
    "until": Word("until c", "End of a `repeat`, or of a motion before its target, when c holds."),
    "while": Word("while c [do] … endw", "Passes through the lines as long as the condition holds."),
    "endw": Word("endw", "End of a `while`."),
    "for": Word("for i = a to b [step s] … endf", "Counts a variable, or with `for each` takes locations."),
    "endf": Word("endf", "End of a `for`."),
    "with": Word("with setting, … endwith", "Settings that hold for the lines of the block."),
    "endwith": Word("endwith", "End of a `with`: what held before holds again."),
    "break": Word("break", "Leaves the innermost loop."),
    "continue": Word("continue", "Goes on with the next pass of the innermost loop."),
    "return": Word("return [value]", "Ends the task, with its value where it has one."),
    "stop": Word('stop ["text"]', "Ends the program."),
    "call": Word("call TASK arguments", "Calls a task; the word may be left out."),
    "print": Word("print value, …", "A message: the values in units of the text, with blanks between."),
}  # fmt: skip

INNER: dict[str, Word] = {
    "and": Word("a and b", "True where both are; both sides are evaluated."),
    "or": Word("a or b", "True where one is; both sides are evaluated."),
    "not": Word("not a", "True where a is false."),
    "mod": Word("a mod b", "Remainder with the sign of the divisor."),
    "in": Word("location in FRAME", "The numbers of the location, read in another frame."),
    "above": Word("location above d", "Moved back by d against the approach direction (tool z)."),
    "offset": Word(
        "location offset (dx, dy, dz)", "Shifted along the axes of the frame in which it was given."
    ),
    "rel": Word("location rel (dx, dy, dz; terms)", "Moved in its own tool frame."),
    "is": Word("value is [not] on|off|true|false", "Compares a truth value."),
    "to": Word("mov to target", "May stand before a target, and stands between the ends of `for`."),
    "then": Word("if c then statement", "Ends the condition; a statement behind it makes it one line."),
    "do": Word("while c do", "May end the head of a loop."),
    "true": Word("true", "The truth value that holds."),
    "false": Word("false", "The truth value that does not hold."),
    "here": Word("here", "Where the arm is commanded to be, for the tool in force."),
    "home": Word("mov home", "The home position of the arm."),
}

LOCATIONS: dict[str, Word] = {
    "external": Word(
        "location external (e1, …)", "The location with the external axes at these values, E1 first."
    ),
    "free": Word(
        "location free",
        "Its position counts: the tool keeps its orientation, or with fewer than six axes turns along.",
    ),
}

MOTIONS: dict[str, Word] = {
    "via": Word("lin via a, … to target", "Points on the way of a motion; `mov` and `lin` pass them by."),
    "angle": Word("angle a", "How far an arc goes on its circle, instead of ending at its target."),
    "store": Word("store NAME", "Keeps the pose that the arm has at the end of the motion."),
    "timeout": Word("until condition timeout t", "Ends the motion after this time, condition or not."),
    "track": Word(
        "track SIGNAL = value [along z] [gain k]",
        "Shifts the path along an axis of the tool so that a sensor reads the value.",
    ),
    "along": Word(
        "lin|spline|mov along LIST, track SIGNAL = value along [-]x|y|z",
        "Through all points of a list; behind `track`: where the tool goes if the sensor reads too much.",
    ),
    "gain": Word("track SIGNAL = value gain k", "Speed of the correction for each unit of the difference."),
    "at": Word(
        "at d after start|before end do set OUTPUT on", "Sets an output on the way, after a way or time."
    ),
}

MODIFIERS: dict[str, Word] = {
    "speed": Word("speed v", "Speed: mm/s or deg/s for `lin`, % of the joint limits for `mov`."),
    "acc": Word("acc a", "Acceleration: mm/s2 for `lin`, % of the joint limits for `mov`."),
    "blend": Word("blend d", "Zone around the target; the simulation stops at the target all the same."),
    "fine": Word("fine", "No zone: the arm stops at the target."),
    "tool": Word("tool NAME", "The tool that reaches the target."),
    "frame": Word("frame NAME", "The frame in which the locations of the following lines are written."),
}

TURNS: dict[str, Word] = {
    "down": Word("down", "Tool straight down: Rx(180°)."),
    "rx": Word("rx a", "Turn about the fixed x axis."),
    "ry": Word("ry a", "Turn about the fixed y axis."),
    "rz": Word("rz a", "Turn about the fixed z axis."),
    "rpy": Word("rpy roll pitch yaw", "Rz(yaw)·Ry(pitch)·Rx(roll)."),
    "euler": Word("euler AXES a b c", "Turns about moving axes, as in `euler ZYX`."),
    "quat": Word("quat w x y z", "Unit quaternion; constants."),
    "rotvec": Word("rotvec x y z", "Rotation vector; constants."),
    "like": Word("like location", "The orientation of another location."),
    "pitch": Word("pitch a", "0 is level, 90° straight down."),
    "roll": Word("roll a", "Turn about the approach direction."),
    "free": Word("free", "The orientation is free: the position counts."),
    "config": Word("config (left, up)", "In which posture the arm reaches the location."),
    "turns": Word("turns (0, -1)", "In which whole turn the axes are there, from the first one on."),
    "yaw": Word("yaw a", "Takes the place of the point's azimuth."),
}

FUNCTIONS: dict[str, Word] = {
    "dist": Word("dist(a, b)", "Distance of two locations."),
    "sqrt": Word("sqrt(x)", "Square root."),
    "sin": Word("sin(a)", "Sine of an angle."),
    "cos": Word("cos(a)", "Cosine of an angle."),
    "tan": Word("tan(a)", "Tangent of an angle."),
    "asin": Word("asin(x)", "Angle of a sine."),
    "acos": Word("acos(x)", "Angle of a cosine."),
    "atan2": Word("atan2(y, x)", "Angle of the point (x, y)."),
    "abs": Word("abs(x)", "Magnitude."),
    "min": Word("min(a, b)", "The smaller one."),
    "max": Word("max(a, b)", "The greater one."),
    "round": Word("round(x)", "Nearest whole number, halves away from zero."),
    "trunc": Word("trunc(x)", "Whole part."),
}

TYPES: dict[str, Word] = {
    "num": Word("num", "A plain number."),
    "int": Word("int", "A whole number."),
    "bool": Word("bool", "A truth value."),
    "str": Word("str", "A text."),
    "length": Word("length", "A length."),
    "angle": Word("angle", "An angle."),
    "time": Word("time", "A time."),
    "speed": Word("speed", "A speed of the TCP."),
    "accel": Word("accel", "An acceleration of the TCP."),
    "force": Word("force", "A force."),
    "loc": Word("loc", "A location: position and orientation."),
    "joints": Word("joints", "Joint coordinates."),
}


def meaning_of(name: str) -> Word | None:
    """Return the meaning of a word of the language, in any case of its letters; None for other words."""
    word = name.lower()
    for table in (STATEMENTS, INNER, LOCATIONS, MOTIONS, MODIFIERS, FUNCTIONS, TURNS, TYPES):
        if word in table:
            return table[word]
    return None
