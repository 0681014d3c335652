"""Diagnostics of exchange files (codes X960 to X963)."""

from ropsim.core import Severity, define

SYNTAX = define(
    "X960",
    "part21-syntax",
    Severity.ERROR,
    "a text is not an exchange file of ISO 10303-21",
    """
An exchange file begins with `ISO-10303-21;` and ends with `END-ISO-10303-21;`. Between them stand a header
and a data section, each of which ends with `ENDSEC;`. An instance has a number, the name of its entity and
its parameters:

    #12=CARTESIAN_POINT('',(0.,0.,0.5));

A real number has a point (`1.`, `2.5E-3`). A parameter without a value is `$`, one that follows from others
is `*`, an item of an enumeration stands between points (`.METRE.`). A string stands between apostrophes, an
apostrophe in it is written twice, and characters beyond the basic ones are written as in `\\X2\\00E9\\X0\\`.
""",
)

NUMBER_TWICE = define(
    "X961",
    "part21-instance-twice",
    Severity.ERROR,
    "two instances of an exchange file have one number",
    """
Instances refer to each other by their numbers, so each number is given once. This happens where two files
are put together by hand: add a constant to all numbers of one of them.
""",
)

NO_INSTANCE = define(
    "X962",
    "part21-dangling-reference",
    Severity.ERROR,
    "a parameter refers to an instance that is not in the file",
    """
Every `#12` in a parameter stands for the instance `#12=…` of the same file. One that is missing was lost when
the file was cut or edited.
""",
)

NOT_READ = define(
    "X963",
    "part21-not-supported",
    Severity.ERROR,
    "an exchange file has a section that is not read, or is larger than what is read",
    """
Files of the second edition of ISO 10303-21 with one data section are read. Sections of the third edition
(anchors, references, signatures) and further data sections are not: write the file as one section. Texts of
up to 4 million characters with 100,000 instances are read; a robot has a few hundred. A file of that size
holds the shapes of a CAD model, which NIROX refers to and does not contain.
""",
)
