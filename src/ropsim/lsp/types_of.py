"""Types of names, in words of the language, as the compiler found them."""

from ropsim.language import Meaning, Role, Space, Uses
from ropsim.workbench import CheckedText


def type_of_meaning(meaning: Meaning, uses: Uses, checked: CheckedText) -> str:
    """Return the type of what a name stands for, empty where nobody knows it."""
    if meaning.space is not Space.SYMBOL:
        return ""
    if meaning.role is Role.PARAMETER:
        form = checked.tasks.get(meaning.task)
        parameters = form.parameters if form is not None else ()
        return next((one.type for one in parameters if one.name == meaning.name), "")
    if meaning.role is Role.VARIABLE:
        of_task = checked.variables.get("" if meaning.is_global else meaning.task, {})
        return of_task.get(_in_program(meaning, uses), "")
    return ""


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
