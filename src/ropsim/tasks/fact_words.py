"""Facts and refusals in words for an operator."""

from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.expression_text import shown


def fact_words(fact: Term) -> str:
    """Return a fact as people say it, behind which it stands as a term where the words are ours."""
    match fact:
        case Struct("gripper", (Atom(state),)):
            return f"{'an' if state.startswith('o') else 'a'} {state} gripper"
        case Struct("at", (Var(), place)):
            return f"a part at `{_name(place)}`"
        case Struct("at", (part, place)):
            return f"`{_name(part)}` at `{_name(place)}`"
        case Struct("held", (Var(),)):
            return "a part in the gripper"
        case Struct("held", (part,)):
            return f"`{_name(part)}` in the gripper"
        case Struct("free", (place,)):
            return f"an empty place `{_name(place)}`"
        case Struct("tool", (tool,)):
            return f"the tool `{_name(tool)}`"
        case Struct("without_gripper", (tool,)):
            return f"the tool `{_name(tool)}` without a gripper"
        case Struct("follows", (part, other)):
            return f"`{_name(part)}` behind `{_name(other)}` in its supply"
    return f"`{_name(fact)}`"


def refusal_words(condition: Term) -> str:
    """Return why a condition of geometry does not hold."""
    match condition:
        case Struct("reachable", (_, place)):
            return f"`{_name(place)}` cannot be reached"
        case Struct("collision_free", (_, part, place)):
            return f"`{_name(part)}` is in something at `{_name(place)}`"
    return f"`{_name(condition)}` does not hold"


def meeting_words(one: str, other: str, depth: float) -> str:
    """Return that two bodies, by what people call them, would be in each other by a depth [m]."""
    return f"{one} would be {max(depth * 1e3, 0.1):.1f} mm deep in {other}"


def beside_words(apart: float, part: str, length: float, depth: float) -> str:
    """Return that parts so far apart [mm] would be in each other by a depth, and their length [m]."""
    deep = f"{max(depth * 1e3, 0.1):.4g}"
    long = f"`{part}` is {length * 1e3:.4g} mm long there"
    return f"parts {apart:.4g} mm apart would be {deep} mm in each other: {long}"


def wider_words(distance: float) -> str:
    """Return from which distance [m] on parts fit beside each other."""
    return f"take a distance of {distance * 1e3:.4g} mm or more"


def place_words(condition: Term) -> str:
    """Return where a condition of geometry is asked for: "at `s1`"."""
    place = condition.arguments[-1] if isinstance(condition, Struct) else condition
    return f"at `{_name(place)}`"


def _name(term: Term) -> str:
    match term:
        case Atom(name) | Var(name):
            return name
        case Struct("p", numbers):
            return f"({', '.join(_name(one) for one in numbers)})"
        case int() | float():
            return f"{term:g}"
        case Struct(name, arguments):
            return f"{name}({', '.join(_name(one) for one in arguments)})"
    return shown(term)
