"""The table of the code of blocks has what the table of their kinds needs."""

from ropsim.blockdiagram import DriveCommand
from ropsim.blockdiagram.testing import BLOCK_FORMS
from ropsim.controller.diagrams.diagram_law import BLOCK_CODE


def test_every_kind_of_block_has_code_or_is_a_filter() -> None:
    filters = {one.block for one in BLOCK_FORMS if one.filter}
    assert not filters & set(BLOCK_CODE)
    assert filters | set(BLOCK_CODE) | {DriveCommand} == {one.block for one in BLOCK_FORMS}
