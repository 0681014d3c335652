"""From a traced graph to straight-line Python source."""

from collections.abc import Sequence
from enum import Enum

from ropsim.codegen.formulas.tracer import Scalar, reachable
from ropsim.codegen.machine.compiler import Bounds
from ropsim.core import frozen_dataclass

_BINARY = {"add": "+", "sub": "-", "mul": "*", "div": "/"}
_CALLS = {
    "abs": "abs",
    "sin": "math.sin",
    "cos": "math.cos",
    "exp": "math.exp",
    "tanh": "math.tanh",
    "sqrt": "math.sqrt",
    "min": "min",
    "max": "max",
    "pow": "math.pow",
}
_INLINE_LENGTH = 72


class Form(Enum):
    """Form of the lines of a function."""

    ANY = "any"
    STRAIGHT_LINE = "straight line"
    ROW_BY_ROW = "row by row"


@frozen_dataclass
class SourceFunction:
    """One function of a generated module.

    Attributes:
        name: of the function.
        signature: numba signature, such as `void(f8[::1], f8[::1])`.
        text: `def` statement without decorators; may use `math`, `np` and functions before it.
        bounds: CHECKED for a text that is not ours; an index beyond an array then ends the call.
        form: STRAIGHT_LINE for functions written by `emit`; they are compiled in a third of the time.
            ROW_BY_ROW for functions made by `row_by_row` of the function before.
    """

    name: str
    signature: str
    text: str
    bounds: Bounds = Bounds.TRUSTED
    form: Form = Form.ANY


def emit(name: str, arguments: Sequence[str], results: Sequence[tuple[str, Scalar]]) -> SourceFunction:
    """Return the function of one-dimensional float64 arrays that assigns every result.

    Operations that no result needs are left out. A value that is used once is written in place, others get a
    name. All inputs are read before the first result is written, so that results may overwrite inputs. Names
    are numbered as they come, so that the same operations have the same text, independent of other traced
    operations: its compiled code is found again.

    Args:
        name: of the function.
        arguments: names of its array arguments, in order.
        results: pairs of target, such as `out[2]`, and value, in order.
    """
    needed = reachable([value for _, value in results])
    uses: dict[int, int] = {}
    for node in needed:
        for arg in node.args:
            uses[arg.index] = uses.get(arg.index, 0) + 1
    for _, value in results:
        uses[value.index] = uses.get(value.index, 0) + 1
    texts: dict[int, str] = {}
    body: list[str] = []
    for node in needed:
        text = _expression(node, texts)
        keep = node.op == "const" or (
            node.op != "var" and uses[node.index] == 1 and len(text) <= _INLINE_LENGTH
        )
        if keep:
            texts[node.index] = text if node.op in {"const", *_CALLS} else f"({text})"
        else:
            texts[node.index] = local = f"t{len(body)}"
            body.append(f"{local} = {text}")
    body += [f"{target} = {texts[value.index]}" for target, value in results]
    lines = "".join(f"    {line}\n" for line in body or ["pass"])
    signature = f"void({', '.join('f8[::1]' for _ in arguments)})"
    text = f"def {name}({', '.join(arguments)}):\n{lines}"
    return SourceFunction(name, signature, text, form=Form.STRAIGHT_LINE)


def row_by_row(name: str, function: SourceFunction, shared: str) -> SourceFunction:
    """Return the function of arrays of rows that calls another one for every row; it must stand behind it.

    Compiled code takes several rows at a time, see `ropsim.codegen.vector.straight_line`: elementary
    functions agree with Python's `math` to rounding. No row depends on another one.

    Args:
        name: of the function.
        function: straight-line code that `emit` has written.
        shared: name of the argument that is the same for all rows; becomes the first one.
    """
    arguments = function.text.partition("(")[2].partition(")")[0].split(", ")
    rows = [one for one in arguments if one != shared]
    called = ", ".join(one if one == shared else f"{one}[k]" for one in arguments)
    text = (
        f"def {name}({', '.join([shared, *rows])}):\n"
        f"    for k in range({rows[0]}.shape[0]):\n"
        f"        {function.name}({called})\n"
    )
    signature = f"void({', '.join(['f8[::1]', *('f8[:,::1]' for _ in rows)])})"
    return SourceFunction(name, signature, text, form=Form.ROW_BY_ROW)


def _expression(node: Scalar, texts: dict[int, str]) -> str:
    if node.op == "const":
        return repr(node.value) if node.value is not None and node.value >= 0.0 else f"({node.value!r})"
    if node.op == "var":
        return f"float({node.text})"
    args = [texts[arg.index] for arg in node.args]
    if node.op in _BINARY:
        return f"{args[0]} {_BINARY[node.op]} {args[1]}"
    if node.op == "neg":
        return f"-{args[0]}"
    return f"{_CALLS[node.op]}({', '.join(args)})"
