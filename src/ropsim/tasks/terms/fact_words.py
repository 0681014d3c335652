"""Facts and refusals in words for an operator."""

from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.tasks.terms.clause_text import term_text
from ropsim.tasks.terms.expression_text import shown
from ropsim.tasks.terms.point import point_of_term, point_text


def fact_words(fact: Term) -> str:
    """Return a fact as people say it, behind which it stands as a term where the words are ours."""
    match fact:
        case Struct("gripper", (Atom(state),)):
            return f"{'an' if state.startswith('o') else 'a'} {state} gripper"
        case Struct("at", (Var(), place)):
            return f"a part at `{name_words(place)}`"
        case Struct("at", (part, place)):
            return f"`{name_words(part)}` at `{name_words(place)}`"
        case Struct("held", (Var(),)):
            return "a part in the gripper"
        case Struct("held", (part,)):
            return f"`{name_words(part)}` in the gripper"
        case Struct("free", (place,)):
            return f"an empty place `{name_words(place)}`"
        case Struct("tool", (tool,)):
            return f"the tool `{name_words(tool)}`"
        case Struct("without_gripper", (tool,)):
            return f"the tool `{name_words(tool)}` without a gripper"
        case Struct("follows", (part, other)):
            return f"`{name_words(part)}` behind `{name_words(other)}` in its supply"
    return _place_words(fact)


def _place_words(fact: Term) -> str:
    """Return facts about machines and racks in plain words."""
    match fact:
        case Struct("loaded", (_, machine)):
            return f"a part in the machine `{name_words(machine)}`"
        case Struct("empty", (Var(),)):
            return "an empty machine"
        case Struct("empty", (machine,)):
            return f"the machine `{name_words(machine)}`, empty,"
        case Struct("chuck_of", (_, place)):
            return f"a machine with its chuck at `{name_words(place)}`"
        case Struct("home_of", (Var(), place)):
            return f"a tool that has its rack at `{name_words(place)}`"
        case Struct("home_of", (tool, place)):
            return f"the rack of `{name_words(tool)}` at `{name_words(place)}`"
    return _logic_words(fact)


def _logic_words(condition: Term) -> str:
    """Return a condition of others as people say it."""
    match condition:
        case Struct("\\=" | "\\==", (one, Var())) | Struct("\\=" | "\\==", (Var(), one)):
            return f"something else than `{name_words(one)}`"
        case Struct("\\+", (fact,)):
            return f"a state without {fact_words(fact)}"
        case Struct(";", (one, other)):
            return f"{fact_words(one)} or {fact_words(other)}"
        case Struct(",", (one, other)):
            return f"{fact_words(one)} and {fact_words(other)}"
    return _pattern_words(condition)


def _pattern_words(condition: Term) -> str:
    """Return a condition of a pattern in plain words, other conditions as a term."""
    match condition:
        case Struct("enough", (place, _, _)):
            return f"as many parts at `{name_words(place)}` as the pattern has places"
        case Struct("vacant", (first, *_)):
            return f"no part at any place of the pattern from `{name_words(first)}` on"
        case Struct("filled", (first, *_)):
            return f"parts at all places of the pattern from `{name_words(first)}` on"
    return f"`{name_words(condition)}`"


def meeting_words(one: str, other: str, depth: float) -> str:
    """Return that two bodies, by their names for users, would be in each other by a depth [m]."""
    return f"{one} would be {max(depth * 1e3, 0.1):.1f} mm deep in {other}"


def beside_words(apart: float, part: str, length: float, depth: float) -> str:
    """Return that parts so far apart [mm] would be in each other by a depth, and their length [m]."""
    deep = f"{max(depth * 1e3, 0.1):.4g}"
    long = f"`{part}` is {length * 1e3:.4g} mm long there"
    return f"parts {apart:.4g} mm apart would be {deep} mm in each other: {long}"


def wider_words(distance: float) -> str:
    """Return the words for the least distance [m] at which adjacent parts fit."""
    return f"take a distance of {distance * 1e3:.4g} mm or more"


def place_words(condition: Term) -> str:
    """Return the words for the place of a condition of geometry: "at `s1`"."""
    place = condition.arguments[-1] if isinstance(condition, Struct) else condition
    return f"at `{name_words(place)}`"


def name_words(term: Term) -> str:
    """Return a thing, a place or a number as people write it."""
    match term:
        case Var():
            return term_text(term)
        case Atom() | Struct("p" | "in") if (point := point_of_term(term)) is not None:
            return point_text(point)
        case int() | float():
            return f"{term:g}"
        case Struct(name, arguments):
            return f"{name}({', '.join(name_words(one) for one in arguments)})"
    return shown(term)
