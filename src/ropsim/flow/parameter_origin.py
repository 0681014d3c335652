"""Where the numbers of a model come from."""

from ropsim.core import frozen_dataclass


@frozen_dataclass
class ParameterOrigin:
    """Where a group of parameters comes from.

    Attributes:
        parameters: covered parameters, such as `motor constants`.
        kind: `published`, `derived` or `estimated`.
        source: paper, table or reasoning.
    """

    parameters: str
    kind: str
    source: str
