"""The value types of the structured program, the same as those of ICR."""

from enum import Enum


class ValueType(Enum):
    """Type of a value; all numbers are SI."""

    BOOL = "BOOL"
    INT = "INT"
    REAL = "REAL"
    STR = "STR"
    VEC = "VEC"
    ORI = "ORI"
    POSE = "POSE"
    JOINTS = "JOINTS"
