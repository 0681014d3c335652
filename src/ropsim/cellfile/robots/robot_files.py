"""The robots that a cell file names: built-in ones by their names, others by the paths of their files."""

from collections.abc import Mapping
from dataclasses import replace

from ropsim import robots
from ropsim.core import Diagnostic, RopsimError, SourceText, frozen_dataclass
from ropsim.model import ReadRobot, RobotModel
from ropsim.tomltext import Question, Sort, TomlTable, document_values

NO_FILES: Mapping[str, ReadRobot] = {}


def is_robot_file(name: str) -> bool:
    """Return whether a robot is given by the path of a file; no built-in name has these signs."""
    return any(sign in name for sign in "/\\.")


def robot_files(text: SourceText | None) -> tuple[str, ...]:
    """Return the paths of the robot files that a cell file names, each once; none where it is no TOML."""
    if text is None:
        return ()
    try:
        values = document_values(text)
    except (ValueError, RecursionError):
        return ()
    stations = values.get("stations")
    tables = [(values.get("robot"), "model")]
    tables += [(one, "robot") for one in stations.values()] if isinstance(stations, dict) else []
    named = [table.get(key) for table, key in tables if isinstance(table, dict)]
    return tuple(dict.fromkeys(one for one in named if isinstance(one, str) and is_robot_file(one)))


@frozen_dataclass
class RobotLibrary:
    """Robots that a cell file can name, in addition to the built-in ones.

    Attributes:
        files: robots of the project by the paths of their files.
    """

    files: Mapping[str, ReadRobot]

    def arm(self, table: TomlTable, key: str) -> RobotModel | None:
        """Return the robot that a key names; None where there is none, which is noted at its value."""
        table.require(key)
        name = table.text(key, "")
        table.ask(key, Question(Sort.TEXT, likely=(*robots.names(), *self.files)))
        if not name and table.values.get(key) != "":  # it is absent or no text, which has been said
            return None
        if name in self.files:
            self._note_unplaced(table, key)
            return self.files[name].robot
        try:
            return robots.load(name)
        except RopsimError as error:
            table.findings.items.append(replace(error.diagnostic, span=table.value_span(key)))
            return None

    def placed_findings(self) -> tuple[Diagnostic, ...]:
        """Return the findings in the files, at places in them."""
        return tuple(one for read in self.files.values() for one in read.findings if one.span is not None)

    def _note_unplaced(self, table: TomlTable, key: str) -> None:
        """Note at the value of a key why its file could not be read."""
        found = self.files[str(table.values[key])].findings
        span = table.value_span(key)
        table.findings.items.extend(replace(one, span=span) for one in found if one.span is None)
