"""A task of a knowledge base as a form: fields of plain text, the other view of its clause."""

from ropsim.core import frozen_dataclass
from ropsim.prolog import Struct
from ropsim.tasks.bodies.body_text import body_lines
from ropsim.tasks.findings.text_diagnostics import NO_TERM
from ropsim.tasks.kinds import TaskError
from ropsim.tasks.programs.task_text import text_names
from ropsim.tasks.programs.typed_step import default_text
from ropsim.tasks.terms.bounds import Bound
from ropsim.tasks.terms.clause_text import term_text
from ropsim.tasks.terms.expression_text import NotTextError
from ropsim.tasks.terms.known_task import KnownTask, Parameter


@frozen_dataclass
class FormParameter:
    """The fields of one parameter.

    Attributes:
        name: its variable, such as `Clear`.
        kind: a word of `KINDS`.
        default: its value if a call omits it, as typed; empty for none.
        word: label for users; empty for none.
        sentence: remark for users.
        bounds: such as `>= 1` or `> 0 mm`.
        called: its name in the text of the body; its variable in small letters where this is empty.
    """

    name: str
    kind: str
    default: str = ""
    word: str = ""
    sentence: str = ""
    bounds: tuple[str, ...] = ()
    called: str = ""


@frozen_dataclass
class TaskForm:
    """The fields of a task; facts and conditions as terms, such as `at(P, L)`, one for each field.

    Attributes:
        name: how it is called.
        doc: purpose.
        parameters: in the order of its head.
        needs: conditions that hold before it.
        effects: `-fact` for removed facts, then `+fact` for added ones.
        geometry: conditions that only geometry decides.
        body: its statements as task text, without `task` and `endp`.
    """

    name: str
    doc: str = ""
    parameters: tuple[FormParameter, ...] = ()
    needs: tuple[str, ...] = ()
    effects: tuple[str, ...] = ()
    geometry: tuple[str, ...] = ()
    body: str = ""


def form_of(task: KnownTask) -> TaskForm:
    """Return the form of a task.

    Raises:
        TaskError: its body has a term that is no statement of task text, so a form cannot show it.
    """
    names = text_names(task)
    try:
        body = body_lines(task.body, names, 0)
    except NotTextError as error:
        message = f"a form cannot show the body of `{task.name}`: {error}"
        raise TaskError(NO_TERM.at(task.span, message, hint="change it in the text")) from error
    gone = tuple(term_text(Struct("-", (one,))) for one in task.removes)
    come = tuple(term_text(Struct("+", (one,))) for one in task.adds)
    return TaskForm(
        task.name,
        task.doc,
        tuple(_parameter(one, names.get(one.name, "")) for one in task.parameters),
        tuple(map(term_text, task.needs)),
        (*gone, *come),
        tuple(map(term_text, task.geometry)),
        "\n".join(body),
    )


def _parameter(one: Parameter, called: str) -> FormParameter:
    bounds = tuple(map(_bound, one.bounds))
    return FormParameter(one.name, one.kind, default_text(one), one.word, one.sentence, bounds, called)


def _bound(one: Bound) -> str:
    return f"{one.sign} {one.number}"
