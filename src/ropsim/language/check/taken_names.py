"""Names that declarations of a text take: cell and text share one name space."""

from collections.abc import Container
from dataclasses import dataclass, field

from ropsim.language.check.scope import hidden
from ropsim.language.check.scope.body import Body
from ropsim.language.environment import Environment
from ropsim.language.findings import hidden as hidden_kinds
from ropsim.language.findings import names as kinds
from ropsim.language.syntax import nodes
from ropsim.language.syntax import statements as syntax

_SAME = {
    syntax.FrameDeclaration: ("a frame",),
    syntax.ToolDeclaration: ("a tool",),
    syntax.LocationDeclaration: ("a location",),
    syntax.SignalDeclaration: ("an input", "an output", "an analog input", "an analog output"),
}
"""Kinds of entities that the cell may have under the name of a declaration: its pose or signal kind holds."""


@dataclass(slots=True)
class TakenNames:
    """Names taken so far.

    Attributes:
        environment: the cell.
        own: names of the tasks of the text.
        declared: names taken by declarations above.
    """

    environment: Environment
    own: Container[str]
    declared: set[str] = field(default_factory=set)

    def take(self, body: Body, node: syntax.Statement, name: nodes.Name) -> None:
        """Take the name of a declaration.

        Raises:
            RejectedError: the text declares it already (N206), or the cell has something else of it (N223).
        """
        if name.text in self.declared:
            body.fail(kinds.DUPLICATE, name, f"`{name.text}` is declared twice", "rename one of them")
        self.declared.add(name.text)
        if name.text in self.own:
            body.fail(kinds.DUPLICATE, name, f"`{name.text}` is a task of this text", "rename one of them")
        of_cell = hidden.in_cell(self.environment, name.text)
        if of_cell and of_cell not in _SAME.get(type(node), ()):
            message = f"`{name.text}` hides {of_cell} of that name, which the cell has"
            body.fail(hidden_kinds.HIDDEN, name, message, "choose another name")
