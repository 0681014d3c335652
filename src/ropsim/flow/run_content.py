"""Content from which a run was made, so that its results are used for the same content only."""

from collections.abc import Mapping
from dataclasses import field

from ropsim.core import frozen_dataclass


@frozen_dataclass
class RunContent:
    """Content from which a run was made, in addition to the identities of its programs.

    Attributes:
        cell: `content` of the work cell; empty where unknown.
        lines: by station, the source line of each instruction of its program, in the order of
            `ropsim.icr.code_lines`; 0 where unknown.
        results: by station, the content on which each line of its program depends, by the number of the line
            in the order of `ropsim.icr.line_contents`.
    """

    cell: str = ""
    lines: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    results: Mapping[str, Mapping[int, str]] = field(default_factory=dict)
