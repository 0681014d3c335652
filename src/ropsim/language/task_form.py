"""How a task is called, in words of the language: for editors and lists of tasks."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class ParameterForm:
    """One parameter.

    Attributes:
        name: as the text writes it.
        type: word of the language, such as `loc` or `length`.
        unit: unit of a bare number in its place, empty where there is none.
        default: value if a call omits it, as written in the text; empty if it is required.
    """

    name: str
    type: str
    unit: str = ""
    default: str = ""

    def __str__(self) -> str:
        unit = f" [{self.unit}]" if self.unit else ""
        return f"{self.name}: {self.type}{unit}{f' = {self.default}' if self.default else ''}"


@frozen_dataclass
class TaskForm:
    """A task from its caller's side.

    Attributes:
        name: of the task.
        parameters: in the order of a call.
        result: type of the value it returns, empty for none.
        is_known: false where its header, or a line that determines its implicit parameters, could not be
            read.
    """

    name: str
    parameters: tuple[ParameterForm, ...] = ()
    result: str = ""
    is_known: bool = True

    def __str__(self) -> str:
        inside = ", ".join(str(parameter) for parameter in self.parameters) if self.is_known else "…"
        return f"{self.name}({inside})" + (f" -> {self.result}" if self.result else "")
