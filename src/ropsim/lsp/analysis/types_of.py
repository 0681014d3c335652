"""Types of names, in words of the language, as the compiler found them."""

from collections.abc import Mapping

from ropsim.language import Meaning, Role, Space, Uses
from ropsim.workbench import CheckedText


def type_of_meaning(meaning: Meaning, uses: Uses, checked: CheckedText) -> str:
    """Return the type of the value of a name, empty if unknown."""
    if meaning.space is not Space.SYMBOL:
        return ""
    if meaning.role is Role.PARAMETER:
        return type_of_parameter(meaning, checked)
    if meaning.role is Role.VARIABLE:
        of_task = checked.variables.get("" if meaning.is_global else meaning.task, {})
        return of_task.get(_in_program(meaning, uses), "")
    return ""


def type_of_parameter(meaning: Meaning, checked: CheckedText) -> str:
    """Return the type of a parameter of a task, empty if unknown and for other names."""
    form = checked.tasks.get(meaning.task) if meaning.role is Role.PARAMETER else None
    parameters = form.parameters if form is not None else ()
    return next((one.type for one in parameters if one.name == meaning.name), "")


def variable_types(uses: Uses, checked: CheckedText) -> Mapping[Meaning, str]:
    """Return the types of all variables of a text that are known, found in one pass."""
    same: dict[tuple[str, str, bool], list[Meaning]] = {}
    for one in uses.meanings():
        if one.space is Space.SYMBOL and one.role is Role.VARIABLE:
            same.setdefault((one.name, one.task, one.is_global), []).append(one)
    types: dict[Meaning, str] = {}
    for (name, task, is_global), meanings in same.items():
        of_task = checked.variables.get("" if is_global else task, {})
        for place, one in enumerate(sorted(meanings, key=lambda meaning: meaning.number)):
            types[one] = of_task.get(name if place == 0 else f"{name}.{place + 1}", "")
    return types


def _in_program(meaning: Meaning, uses: Uses) -> str:
    """Return the name of a variable in the structured program, where the second of a name has a number."""
    same = [
        one
        for one in uses.meanings()
        if (one.name, one.task, one.role, one.is_global)
        == (meaning.name, meaning.task, Role.VARIABLE, meaning.is_global)
    ]
    place = sorted(one.number for one in same).index(meaning.number)
    return meaning.name if place == 0 else f"{meaning.name}.{place + 1}"
