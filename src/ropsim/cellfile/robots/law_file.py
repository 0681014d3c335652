"""The file of a joint controller that a cell file names."""

from dataclasses import replace
from pathlib import PurePosixPath

from ropsim.cellfile.diagnostics import LAW_FILE
from ropsim.core import LeadsOutError, check_stated, outside_project
from ropsim.model import (
    DIAGRAM_ENDINGS,
    MODULE_ENDING,
    ControllerKind,
    ControllerModel,
    LawFile,
    OriginKind,
    ParameterOrigin,
    gain_names,
)
from ropsim.tomltext import CONFLICTING_KEYS, Question, Sort, TomlTable

ENDINGS = (*DIAGRAM_ENDINGS, MODULE_ENDING)
"""Endings of files of joint controllers."""
_GAINS = "controller gains"


def with_law_file(table: TomlTable, controller: ControllerModel) -> ControllerModel:
    """Return a controller whose law is in the file that the key `file` names; its text is not read here.

    Args:
        table: section `[controller]` with that key.
        controller: the standard one of the robot, which keeps everything else.
    """
    table.ask("file", Question(Sort.TEXT))
    path = table.text("file", "")
    span = table.value_span("file")
    if not path:
        if table.values["file"] == "":
            table.findings.add(LAW_FILE, span, "the path of the file is empty")
        return controller
    for key in ("law", *gain_names(controller.gains)):
        if key in table:
            message = f"`{table.name_of(key)}` belongs to a built-in law, and `file` says another one"
            table.findings.add(CONFLICTING_KEYS, table.key_span(key), message, "keep one of them")
    if PurePosixPath(path).suffix.lower() not in ENDINGS:
        allowed = ", ".join(f"`{one}`" for one in ENDINGS)
        message = f"`{path[:200]}` is no file of a joint controller, these end with {allowed}"
        table.findings.add(LAW_FILE, span, message)
        return controller
    try:
        check_stated(path)
    except LeadsOutError as error:
        table.findings.items.append(outside_project(path, error, span))
        return controller
    if controller.kind is ControllerKind.IDEAL:
        message = "the robot has no drives: it follows its reference exactly and takes no joint controller"
        hint = "`ropsim robot estimate` adds drives by stated rules"
        table.findings.add(LAW_FILE, span, message, hint)
        return controller
    others = tuple(one for one in controller.origins if one.parameters != _GAINS)
    origin = ParameterOrigin("joint controller", OriginKind.DERIVED, f"the law in `{path}`")
    return replace(controller, kind=ControllerKind.FILE, gains=LawFile(path), origins=(origin, *others))
