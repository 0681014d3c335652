"""What a program names and its station has not is told at the name."""

import pytest

from ropsim.core import SourceText
from ropsim.workbench import Workspace

CELL = SourceText("cell.toml", '[cell]\nprogram = "p"\n[robot]\nmodel = "puma560"\n')


@pytest.mark.parametrize(
    ("name", "text", "place"),
    [
        ("p.task", "signal ready = input 1\nwait 1 s\nwait until ready\n", (1, 8, 13)),
        (
            "p.icr",
            "ICR 1.0 p\nREQUIRE CAP IO\nIO DI ready BOOL\nPROC main\nIN ready\nPOP\nHALT\nEND\n",
            (3, 1, 3),
        ),
    ],
)
def test_a_signal_that_the_cell_does_not_have_is_marked(
    name: str, text: str, place: tuple[int, int, int]
) -> None:
    workspace = Workspace()
    (found,) = workspace.compiled(SourceText(name, text), workspace.at(CELL, "c", "")).diagnostics
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column, found.span.end_column) == ("X846", *place)
