"""Diagnostics of schemas and of instances checked against them (codes X964 to X973)."""

from ropsim.core import Severity, define

SYNTAX = define(
    "X964",
    "express-syntax",
    Severity.ERROR,
    "a text is not a schema in the part of EXPRESS that is understood",
    """
Schemas are read in a part of the language EXPRESS (ISO 10303-11): types (simple, enumeration, select,
aggregates), entities with supertypes, optional, derived and inverse attributes, UNIQUE and WHERE, and global
rules; in expressions the operators, QUERY, SIZEOF, EXISTS, NVL, ABS, SQRT and TYPEOF. There are no functions,
procedures, constants or schemas that use each other.
""",
)

UNKNOWN_NAME = define(
    "X965",
    "express-unknown-name",
    Severity.ERROR,
    "a schema uses a name that it does not declare, or declares one twice",
    """
Supertypes, types of attributes and names in rules are declared in the schema. A name in a rule of an entity
is one of its attributes, inherited ones included, a variable of a QUERY, or an item of an enumeration; in a
global rule it may also be one of the entities that the rule is for.
""",
)

UNKNOWN_ENTITY = define(
    "X966",
    "instance-of-unknown-entity",
    Severity.WARNING,
    "an instance is of an entity that the schema does not have",
    """
The instance stays in the file when that is written again, and nothing else is done with it. Newer versions of
a schema add entities, and so do other programs; a misspelt name looks the same.
""",
)

IMPOSSIBLE_ENTITY = define(
    "X967",
    "instance-of-impossible-entity",
    Severity.ERROR,
    "an instance is of an abstract entity, or of entities that exclude each other",
    """
Of an abstract entity there are only instances of its subtypes: a `kinematic_pair` is a `revolute_pair` or
another one. A complex instance, `#1=(A(…)B(…));`, names all supertypes of its entities, and no two entities
that the schema puts into one ONEOF.
""",
)

WRONG_COUNT = define(
    "X968",
    "wrong-parameter-count",
    Severity.ERROR,
    "an instance has more or fewer parameters than its entity",
    """
Parameters are told apart by their places: first those of the supertypes, then those of the entity. One that
has no value is `$`, one that follows from others is `*`; neither is left out.
""",
)

WRONG_VALUE = define(
    "X969",
    "wrong-parameter-value",
    Severity.ERROR,
    "a parameter is not of the type that its attribute has",
    """
The message tells what was found and what is allowed. Real numbers have a point (`1.`), items of enumerations
stand between points, `$` is allowed for optional attributes only, and `*` for derived ones only.
""",
)

RULE_BROKEN = define(
    "X970",
    "rule-broken",
    Severity.ERROR,
    "a rule of the schema does not hold",
    """
The message names the rule by its entity or type and its label. Rules say what no type can: that a mass is not
negative, that the supply pressure is above the return pressure, that a lower limit is below the upper one.
The schema stands in `nirox_v1.exp`, each rule with its reason.
""",
)

UNDECIDED = define(
    "X971",
    "rule-undecided",
    Severity.HINT,
    "a rule of the schema could not be decided",
    """
Rules are logical expressions with three values: a value that is missing makes an expression UNKNOWN, which
breaks no rule. The hint names such rules, for a rule that never decides checks nothing. Where so much
stands in a file that checking it would take too long, the rest of the rules is left undecided, too.
""",
)

DOUBTFUL = define(
    "X972",
    "doubtful-instance",
    Severity.WARNING,
    "a rule of the schema about what is to be expected does not hold",
    """
Rules whose label begins with `doubt` are about numbers that no rigid body can have but that published sets of
data contain, such as moments of inertia with A + B < C, and about data that most uses need, such as the
mass of a link. The file can be used; look at the numbers.
""",
)

NOT_UNIQUE = define(
    "X973",
    "instances-not-unique",
    Severity.ERROR,
    "two instances agree where they have to differ",
    """
A UNIQUE rule names attributes that together differ from instance to instance: a link has one set of mass
properties, a pair one drive train. One of the two instances is too many.
""",
)
