"""Declarations of a schema of ISO 10303-11: types, entities and rules."""

from ropsim.core import frozen_dataclass
from ropsim.express.expressions import Expression
from ropsim.express.types import Underlying, ValueType


@frozen_dataclass
class WhereRule:
    """A condition that holds.

    Attributes:
        label: its name, such as `wr1`.
        condition: FALSE breaks the rule.
    """

    label: str
    condition: Expression

    @property
    def is_doubt(self) -> bool:
        """Return whether a violation is only a doubt: its label begins with `doubt`."""
        return self.label.startswith("doubt")


@frozen_dataclass
class Attribute:
    """An explicit attribute: a parameter in an exchange file.

    Attributes:
        name: in lower case.
        type: of its value.
        optional: whether it may be unset.
        redeclares: the supertype whose attribute of this name it narrows; empty for an attribute of its own.
    """

    name: str
    type: ValueType
    optional: bool = False
    redeclares: str = ""


@frozen_dataclass
class DerivedAttribute:
    """An attribute that follows from others.

    Attributes:
        name: in lower case.
        expression: its value.
        redeclares: the supertype whose explicit attribute it replaces, which is `*` in a file; or empty.
    """

    name: str
    expression: Expression
    redeclares: str = ""


@frozen_dataclass
class InverseAttribute:
    """The instances that refer to this one.

    Attributes:
        name: in lower case.
        entity: of those instances.
        attribute: by which they refer.
        lower: least number of them.
        upper: greatest number; None for any.
        single: whether it stands for the one instance and not for a set.
    """

    name: str
    entity: str
    attribute: str
    lower: int
    upper: int | None
    single: bool = False


@frozen_dataclass
class UniqueRule:
    """Attributes that together differ from instance to instance.

    Attributes:
        label: its name, such as `ur1`.
        attributes: attributes that differ.
    """

    label: str
    attributes: tuple[Expression, ...]


@frozen_dataclass
class Entity:
    """The declaration of an entity.

    Attributes:
        name: in lower case.
        abstract: whether only subtypes of it have instances.
        one_of: groups of subtypes of which an instance has at most one.
        supertypes: their names, in order.
        attributes: its own explicit ones, in order.
        derived: attributes that follow from others.
        inverses: attributes that lead back.
        uniques: attributes that differ from instance to instance.
        rules: conditions of each instance.
    """

    name: str
    abstract: bool = False
    one_of: tuple[tuple[str, ...], ...] = ()
    supertypes: tuple[str, ...] = ()
    attributes: tuple[Attribute, ...] = ()
    derived: tuple[DerivedAttribute, ...] = ()
    inverses: tuple[InverseAttribute, ...] = ()
    uniques: tuple[UniqueRule, ...] = ()
    rules: tuple[WhereRule, ...] = ()


@frozen_dataclass
class TypeDeclaration:
    """A type with a name.

    Attributes:
        name: in lower case.
        underlying: its underlying type.
        rules: conditions of each value.
    """

    name: str
    underlying: Underlying
    rules: tuple[WhereRule, ...] = ()


@frozen_dataclass
class GlobalRule:
    """Condition on all instances of some entities together.

    Attributes:
        name: in lower case.
        entities: whose instances its conditions name.
        rules: the conditions.
    """

    name: str
    entities: tuple[str, ...]
    rules: tuple[WhereRule, ...]
