"""The files that a cell file names for the entities of a controller."""

from dataclasses import replace
from pathlib import PurePosixPath

from ropsim.cellfile.diagnostics import LAW_FILE
from ropsim.core import LeadsOutError, check_stated, outside_project
from ropsim.model import (
    DIAGRAM_ENDINGS,
    MODULE_ENDING,
    ControllerFile,
    ControllerKind,
    ControllerModel,
    Entity,
    NamedEntity,
    OriginKind,
    OwnEntity,
    ParameterOrigin,
    gain_names,
)
from ropsim.planning import BUILT_IN
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
    path = _path(table, "file", ENDINGS)
    span = table.value_span("file")
    for key in ("law", *gain_names(controller.gains)):
        if key in table:
            message = f"`{table.name_of(key)}` belongs to a built-in law, and `file` says another one"
            table.findings.add(CONFLICTING_KEYS, table.key_span(key), message, "keep one of them")
    if not path:
        return controller
    if controller.kind is ControllerKind.IDEAL:
        message = "the robot has no drives: it follows its reference exactly and takes no joint controller"
        hint = "`ropsim robot estimate` adds drives by stated rules"
        table.findings.add(LAW_FILE, span, message, hint)
        return controller
    others = tuple(one for one in controller.origins if one.parameters != _GAINS)
    origin = ParameterOrigin("joint controller", OriginKind.DERIVED, f"the law in `{path}`")
    return replace(
        controller, kind=ControllerKind.FILE, gains=ControllerFile(path), origins=(origin, *others)
    )


def read_entities(table: TomlTable) -> tuple[tuple[OwnEntity, ...], tuple[NamedEntity, ...]]:
    """Return the entities of a controller that modules of the project make, and the built-in ones by name.

    Args:
        table: `[controller.entities]`, or a stand-in.
    """
    own, chosen = list[OwnEntity](), list[NamedEntity]()
    for entity in Entity:
        words = tuple(BUILT_IN[entity])
        if table.values.get(entity.value) in words:
            chosen.append(NamedEntity(entity, table.text(entity.value, "")))
        elif entity.value in table:
            path = _path(table, entity.value, (MODULE_ENDING,), words)
            own += [OwnEntity(entity, ControllerFile(path))] if path else []
        table.ask(entity.value, Question(Sort.TEXT, likely=words))
    table.finish()
    return tuple(own), tuple(chosen)


def _path(table: TomlTable, key: str, endings: tuple[str, ...], words: tuple[str, ...] = ()) -> str:
    """Return the path of a file in the project; empty where it cannot be one, which is noted.

    Args:
        table: section with the key.
        key: of the path.
        endings: that are allowed.
        words: that are allowed in place of a path.
    """
    path = table.text(key, "")
    span = table.value_span(key)
    if not path:
        if table.values[key] == "":
            table.findings.add(LAW_FILE, span, "the path of the file is empty")
        return ""
    if PurePosixPath(path).suffix.lower() not in endings:
        allowed = ", ".join(f"`{one}`" for one in endings)
        message = f"`{path[:200]}` is no file for `{table.name_of(key)}`, these end with {allowed}"
        others = ", ".join(f"`{one}`" for one in words)
        table.findings.add(LAW_FILE, span, message, f"built-in ones are {others}" if words else "")
        return ""
    try:
        check_stated(path)
    except LeadsOutError as error:
        table.findings.items.append(outside_project(path, error, span))
        return ""
    return path
