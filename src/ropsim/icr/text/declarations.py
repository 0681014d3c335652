"""The declarations at the head of an ICR text."""

from ropsim.core import Span
from ropsim.icr.program import (
    FrameDefinition,
    IoChannel,
    LibraryText,
    PoseList,
    Procedure,
    Program,
    ToolDefinition,
    Variable,
    channel_fault,
)
from ropsim.icr.text.literals import read_int, read_reals
from ropsim.icr.text.tokens import Token, is_name
from ropsim.icr.types import Type
from ropsim.spatial import PoseTuple


class Declarations:
    """Collects the records at the head, SOURCE to ROW."""

    def __init__(self) -> None:
        self.name = ""
        self.source = ""
        self.libraries: list[LibraryText] = []
        self.axes: int | None = None
        self.capabilities: set[str] = set()
        self.variables: list[Variable] = []
        self.channels: list[IoChannel] = []
        self.frames: list[FrameDefinition] = []
        self.tools: list[ToolDefinition] = []
        self.lists: dict[str, list[PoseTuple]] = {}
        self._rows: list[PoseTuple] | None = None
        self.declared_at: dict[str, Span] = {}

    def program(self, procedures: tuple[Procedure, ...]) -> Program:
        """Return the program of these declarations and `procedures`."""
        return Program(
            self.name,
            procedures,
            capabilities=tuple(sorted(self.capabilities)),
            axes=self.axes,
            variables=tuple(self.variables),
            channels=tuple(self.channels),
            frames=tuple(self.frames),
            tools=tuple(self.tools),
            lists=tuple(PoseList(name, tuple(rows)) for name, rows in self.lists.items()),
            source=self.source,
            libraries=tuple(self.libraries),
            declared_at=self.declared_at,
        )

    def read(self, words: tuple[Token, ...], place: Span) -> tuple[str, str]:
        """Take one record in.

        Returns:
            The fault in its form, and the name that it declares a second time; both empty if correct.
        """
        head, rest = words[0].text, words[1:]
        if head == "ROW":
            return self._row(rest), ""
        self._rows = None
        if head == "SOURCE":
            return self._source(rest, place)
        if head == "REQUIRE":
            return self._require(rest, place)
        at = 1 if head == "IO" else 0
        if len(rest) <= at or not is_name(rest[at]):
            return "a name is needed", ""
        name = rest[at].text
        readers = {
            "VAR": self._var,
            "IO": self._io,
            "FRAMEDEF": self._frame,
            "TOOLDEF": self._tool,
            "LIST": self._list,
        }
        problem = {**readers, "TASKTEXT": self._library}[head](name, rest)
        key = f"{head} {name}"
        twice = f"`{key}`" if key in self.declared_at else ""
        self.declared_at.setdefault(key, place)
        return problem, twice

    def _source(self, rest: tuple[Token, ...], place: Span) -> tuple[str, str]:
        if len(rest) != 1 or not (rest[0].is_quoted or is_name(rest[0])):
            return "one text is needed", ""
        twice = "`SOURCE`" if "SOURCE" in self.declared_at else ""
        self.declared_at["SOURCE"] = place
        self.source = rest[0].text
        return "", twice

    def _require(self, rest: tuple[Token, ...], place: Span) -> tuple[str, str]:
        if len(rest) > 1 and rest[0].text == "CAP" and all(is_name(word) for word in rest):
            self.capabilities.update(word.text for word in rest[1:])
            self.declared_at["REQUIRE CAP"] = place
            return "", ""
        axes = read_int(rest[1]) if len(rest) == 2 and rest[0].text == "AXES" else None
        if axes is None:
            return "`AXES` and a number, or `CAP` and names are needed", ""
        twice = "`REQUIRE AXES`" if self.axes is not None else ""
        self.axes = axes
        self.declared_at["REQUIRE AXES"] = place
        return "", twice

    def _library(self, name: str, rest: tuple[Token, ...]) -> str:
        if len(rest) != 3 or not all(one.is_quoted for one in rest[1:]):
            return "the name of a procedure and two texts in quotes are needed"
        self.libraries.append(LibraryText(name, rest[1].text, rest[2].text))
        return ""

    def _var(self, name: str, rest: tuple[Token, ...]) -> str:
        if len(rest) != 2 or rest[1].text not in Type.__members__:
            return "a name and a type are needed"
        self.variables.append(Variable(name, Type(rest[1].text)))
        return ""

    def _io(self, name: str, rest: tuple[Token, ...]) -> str:
        if len(rest) != 3 or rest[2].text not in Type.__members__:
            return "a kind, a name and a type are needed"
        channel = IoChannel(name, rest[0].text, Type(rest[2].text))
        self.channels.append(channel)
        return channel_fault(channel)

    def _frame(self, name: str, rest: tuple[Token, ...]) -> str:
        pose = _pose(rest[1:])
        if pose is None:
            return "seven numbers are needed"
        self.frames.append(FrameDefinition(name, pose))
        return ""

    def _list(self, name: str, rest: tuple[Token, ...]) -> str:
        if len(rest) != 1:
            return "one name is needed"
        self._rows = self.lists.setdefault(name, [])
        return ""

    def _row(self, rest: tuple[Token, ...]) -> str:
        pose = _pose(rest)
        if self._rows is None:
            return "stands only below `LIST name` or another `ROW`"
        if pose is None:
            return "seven numbers are needed"
        self._rows.append(pose)
        return ""

    def _tool(self, name: str, rest: tuple[Token, ...]) -> str:
        pose = _pose(rest[1:])
        if pose is None and len(rest) > 1:
            return "seven numbers are needed, or none"
        self.tools.append(ToolDefinition(name, pose))
        return ""


def _pose(words: tuple[Token, ...]) -> PoseTuple | None:
    numbers = read_reals(words)
    if numbers is None or len(numbers) != 7:
        return None
    x, y, z, qw, qx, qy, qz = numbers
    return (x, y, z, qw, qx, qy, qz)
