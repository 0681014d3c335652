"""Of what a run was made, so that what it says can be told of the same content alone."""

from collections.abc import Mapping
from dataclasses import field

from ropsim.core import frozen_dataclass


@frozen_dataclass
class RunContent:
    """What a run was made of, beside the identities of its programs.

    Attributes:
        cell: `content` of the work cell; empty where unknown.
        lines: by station, the source line of each instruction of its program, in the order of
            `ropsim.icr.code_lines`; 0 where unknown.
        results: by station, what the result of each line of its program hangs on, by the number of the line
            in the order of `ropsim.icr.line_contents`.
    """

    cell: str = ""
    lines: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    results: Mapping[str, Mapping[int, str]] = field(default_factory=dict)
