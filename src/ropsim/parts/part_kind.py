"""Records of the part library: kinds of parts with their parameters, products, and finished parts."""

from collections.abc import Callable, Mapping
from dataclasses import field
from enum import StrEnum
from typing import TypeAlias

from ropsim.core import frozen_dataclass
from ropsim.model import LIGHT_GREY, Gripper, OriginKind, Payload, Shape
from ropsim.spatial import Pose, record

Values: TypeAlias = Mapping[str, float]
"""Values of parameters by name, in SI units."""

TCP = "tcp"
"""Parameter with the distance of the TCP from the mechanical interface."""


class Use(StrEnum):
    """Table of a cell file that a part is for: a tool, a fixed object, or a device of that kind."""

    TOOL = "tool"
    OBJECT = "object"
    CONVEYOR = "conveyor"
    TURNTABLE = "turntable"


class Measure(StrEnum):
    """Quantity of a parameter."""

    LENGTH = "length"
    MASS = "mass"
    TIME = "time"
    COUNT = "count"


@frozen_dataclass
class Parameter:
    """A number that a kind of part is made from.

    Attributes:
        name: key in a cell file.
        measure: its quantity.
        default: value if the user and the product have none [SI]; None for a value that follows
            from the others, as `meaning` says.
        low: least value allowed [SI].
        high: greatest value allowed [SI].
        meaning: one sentence.
        origin: of the default.
        source: of the default and of the usual range; empty for an estimate by eye.
    """

    name: str
    measure: Measure
    default: float | None
    low: float
    high: float
    meaning: str
    origin: OriginKind = OriginKind.ESTIMATED
    source: str = ""

    def allows(self, value: float) -> bool:
        """Return whether a value [SI] is in the range, and whole for a number of pieces."""
        is_whole = self.measure is not Measure.COUNT or value % 1.0 == 0.0
        return self.low <= value <= self.high and is_whole


@frozen_dataclass
class UpperBound:
    """A bound: a parameter must not exceed another one.

    Attributes:
        small: name of the one.
        large: name of the other.
        of_several: names of parameters that count pieces; the bound holds where there are several of one.
            Empty for a bound that always holds.
    """

    small: str
    large: str
    of_several: tuple[str, ...] = ()

    def is_kept(self, values: Values) -> bool:
        """Return whether values [SI] keep it; a parameter without a value keeps any bound."""
        if self.small not in values or self.large not in values:
            return True
        is_free = self.of_several and all(values.get(name, 1.0) <= 1.0 for name in self.of_several)
        return bool(is_free) or values[self.small] <= values[self.large]


@frozen_dataclass
class Fact:
    """A published figure of a product that its part is not made from.

    Attributes:
        name: such as `grip force`.
        values: one value, least and greatest, or three edges.
        unit: as it is shown.
    """

    name: str
    values: tuple[float, ...]
    unit: str


@frozen_dataclass
class Product:
    """A named product: values of parameters with their origin.

    Attributes:
        name: key in a cell file, such as `franka_hand`.
        title: name by the maker or the standard.
        values: parameters with a value in the source [SI].
        origin: of these values.
        source: file, standard or page that the values are from.
        estimates: further parameters, estimated by eye [SI].
        facts: further figures of the source.
    """

    name: str
    title: str
    values: Values
    origin: OriginKind
    source: str
    estimates: Values = field(default_factory=dict)
    facts: tuple[Fact, ...] = ()


@record
class LibraryPart:
    """A finished part.

    Attributes:
        shapes: of its fixed body; of a tool in the mechanical interface frame, of a device in its base frame.
        moving_shapes: of the body that a device moves, in the frame of that.
        load: mass, centre of mass and inertia, in the frame of the shapes.
        X_MT: tool frame in the mechanical interface frame; None for a part that is no tool.
        gripper: of a tool that grasps.
        colour: main colour, of the shapes that are painted in another colour on request.
    """

    shapes: tuple[Shape, ...]
    moving_shapes: tuple[Shape, ...] = ()
    load: Payload = Payload()
    X_MT: Pose | None = None
    gripper: Gripper | None = None
    colour: str = LIGHT_GREY


@frozen_dataclass
class PartKind:
    """A kind of part: a function from parameters to a part, with the ranges in which it holds.

    Attributes:
        name: key in a cell file.
        title: name in a list.
        use: table of a cell file that it is for.
        frame: where its frame lies, a sentence.
        parameters: in the order in which they are listed.
        make: returns the part for values of all parameters that have one.
        products: named products.
        at_most: bounds between parameters.
    """

    name: str
    title: str
    use: Use
    frame: str
    parameters: tuple[Parameter, ...]
    make: Callable[[Values], LibraryPart]
    products: tuple[Product, ...] = ()
    at_most: tuple[UpperBound, ...] = ()

    def product(self, name: str) -> Product | None:
        """Return the product of a name, None for an unknown one."""
        return next((one for one in self.products if one.name == name), None)

    def defaults(self, product: Product | None = None) -> dict[str, float]:
        """Return the values of a product, completed by the defaults of the kind [SI]."""
        own = {one.name: one.default for one in self.parameters if one.default is not None}
        return own if product is None else {**own, **product.estimates, **product.values}

    def conflict(self, values: Values) -> tuple[Parameter, Parameter] | None:
        """Return the first two parameters of which one exceeds its upper bound, the other; None for none."""
        known = {one.name: one for one in self.parameters}
        broken = (bound for bound in self.at_most if not bound.is_kept(values))
        return next(((known[one.small], known[one.large]) for one in broken), None)

    def tcp_origin(self, product: Product | None = None) -> OriginKind:
        """Return how the TCP of a tool is known: as a figure of its product, or by estimates."""
        return product.origin if product and TCP in product.values else OriginKind.ESTIMATED
