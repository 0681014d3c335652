"""The robots that a cell file names: built-in ones by their names, others by the paths of their files."""

from collections.abc import Mapping
from dataclasses import replace

from ropsim import robots
from ropsim.core import (
    Diagnostic,
    LeadsOutError,
    RopsimError,
    SourceText,
    Span,
    check_stated,
    frozen_dataclass,
    outside_project,
)
from ropsim.model import REQUEST, ReadRobot, RobotModel, RobotSource
from ropsim.tomltext import Question, Sort, TomlTable, document_values

NO_FILES: Mapping[RobotSource, ReadRobot] = {}
_SIMPLE = (str, bool, int, float)
"""Types of the arguments of a xacro file; folders of packages are texts."""
FOREIGN_ENDINGS = (".urdf", ".xacro", ".xml")
"""Endings of robot files in formats of others."""


def is_foreign_file(path: str) -> bool:
    """Return whether a robot file is in a format of others, which takes `tip`, `package` and `arg`."""
    return path.lower().endswith(FOREIGN_ENDINGS)


def is_robot_file(name: str) -> bool:
    """Return whether a robot is given by the path of a file; no built-in name has these signs."""
    return any(sign in name for sign in "/\\.")


def robot_files(text: SourceText | None) -> tuple[RobotSource, ...]:
    """Return the robot files that a cell file names, each once; none where it is no TOML."""
    if text is None:
        return ()
    try:
        values = document_values(text)
    except (ValueError, RecursionError):
        return ()
    stations = values.get("stations")
    tables = [(values.get("robot"), "model")]
    tables += [(one, "robot") for one in stations.values()] if isinstance(stations, dict) else []
    named = [_source(table, key) for table, key in tables if isinstance(table, dict)]
    return tuple(dict.fromkeys(one for one in named if one is not None))


def _source(table: Mapping[str, object], key: str) -> RobotSource | None:
    """Return the robot file that a table names; None for a built-in robot.

    Values of other types are left out; `RobotLibrary` notes them.

    Args:
        table: `[robot]` or `[stations.NAME]`.
        key: that names the robot.
    """
    path, tip = table.get(key), table.get("tip")
    if not isinstance(path, str) or not is_robot_file(path):
        return None
    if not is_foreign_file(path):
        return RobotSource(path)
    packages = tuple(pair for pair in _texts(table.get("package")) if _stays_inside(pair[1]))
    return RobotSource(path, tip if isinstance(tip, str) else "", packages, _texts(table.get("arg"), _SIMPLE))


def _texts(value: object, types: tuple[type, ...] = (str,)) -> tuple[tuple[str, str], ...]:
    """Return the pairs of an inline table whose values have certain types, as texts of xacro."""
    if not isinstance(value, dict):
        return ()
    return tuple((name, _word(one)) for name, one in value.items() if isinstance(one, types))


def _stays_inside(path: str) -> bool:
    try:
        check_stated(path)
    except LeadsOutError:
        return False
    return True


def _word(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


@frozen_dataclass
class RobotLibrary:
    """Robots that a cell file can name, in addition to the built-in ones.

    Attributes:
        files: robots of the project by their files, with what the cell file requests of them.
    """

    files: Mapping[RobotSource, ReadRobot]

    def arm(self, table: TomlTable, key: str) -> RobotModel | None:
        """Return the robot that a key names; None where there is none, which is noted at its value."""
        table.require(key)
        name = table.text(key, "")
        paths = dict.fromkeys(source.path for source in self.files)
        table.ask(key, Question(Sort.TEXT, likely=(*robots.names(), *paths)))
        if not name and table.values.get(key) != "":  # it is absent or no text, which has been said
            return None
        source = _source(table.values, key)
        if source is not None and is_foreign_file(name):
            _check_request(table)
        if source is not None and source in self.files:
            self._note_here(self.files[source], table, key)
            return self.files[source].robot
        try:
            return robots.load(name)
        except RopsimError as error:
            table.findings.items.append(replace(error.diagnostic, span=table.value_span(key)))
            return None

    def placed_findings(self) -> tuple[Diagnostic, ...]:
        """Return the findings in the files, at places in them."""
        return tuple(
            one
            for read in self.files.values()
            for one in read.findings
            if one.span is not None and REQUEST not in one.data
        )

    def _note_here(self, read: ReadRobot, table: TomlTable, key: str) -> None:
        """Note mistakes in requests at their keys, and at the value of a key why its file is not read."""
        for one in read.findings:
            if REQUEST in one.data:
                path = one.data[REQUEST]
                table.findings.items.append(
                    replace(one, span=_request_span(path, table, key), label=f"in `{table.values[key]}`")
                )
            elif one.span is None:
                table.findings.items.append(replace(one, span=table.value_span(key)))


def _request_span(path: object, table: TomlTable, key: str) -> Span:
    """Return where the key of a request stands; the value of the robot where it is not there."""
    steps = path if isinstance(path, tuple) else ()
    values: object = table.values
    for step in steps:
        if not isinstance(values, dict) or step not in values:
            return table.value_span(key)
        values = values[step]
    return table.findings.places.key((*table.path, *steps)) if steps else table.value_span(key)


def _check_request(table: TomlTable) -> None:
    """Read the keys that say how a robot file is read, to note mistakes in them."""
    table.text("tip", "")
    for name, types in (("package", (str,)), ("arg", _SIMPLE)):
        inner = table.table(name)
        for key, value in inner.values.items():
            if key in inner and not isinstance(value, types):
                inner.wrong_type((key,), value, "text in quotation marks")
            elif name == "package" and key in inner:
                _check_package(inner, key, value)


def _check_package(inner: TomlTable, key: str, value: object) -> None:
    """Note the folder of a package that is not in the project."""
    try:
        check_stated(str(value))
    except LeadsOutError as error:
        inner.findings.items.append(outside_project(str(value), error, inner.value_span(key)))
