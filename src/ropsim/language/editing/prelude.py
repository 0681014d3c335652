"""What a text defines, without its actions; and whether more lines must follow."""

from ropsim.core import SourceText
from ropsim.language.blocks.block_ends import indented
from ropsim.language.blocks.taken import told
from ropsim.language.cache import LineCache
from ropsim.language.syntax.statements import DECLARATIONS, TaskHeader
from ropsim.language.syntax.text import Line, read


def prelude(text: str) -> str:
    """Return the declarations and tasks of a text on the lines where they stand, all other lines empty."""
    source = SourceText("", text)
    kept = [""] * len(source.lines)
    lines = told(list(read(source, LineCache())))
    ends = [*(line.logical.number - 1 for line in lines[1:]), len(source.lines)]
    is_task = False
    for (line, depth), end in zip(indented(lines), ends, strict=True):
        is_header = isinstance(line.statement, TaskHeader)
        if is_header or is_task or (depth == 0 and isinstance(line.statement, DECLARATIONS)):
            begin = line.logical.number - 1
            kept[begin:end] = source.lines[begin:end]
        is_task = is_header or (is_task and not (depth == 0 and line.statement is not None))
    return "\n".join(kept)


def goes_on(text: str) -> bool:
    """Return whether a text ends within a block, or within a statement that the next line would continue.

    A text whose first statement is refused begins no block.
    """
    source = SourceText("", text + "\n0")  # an incomplete last line takes this line in
    lines = list(read(source, LineCache()))
    if lines[-1].logical.number < len(source.lines):
        return True
    own = told(lines[:-1])
    first = next((line for line in own if line.statement is not None or line.fault is not None), None)
    if first is None or first.fault is not None:
        return False
    depths = list(indented([*own, Line.empty()]))
    return depths[-1][1] > 0
