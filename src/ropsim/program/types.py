"""The value types of the structured program: the types of ICR."""

from ropsim.icr import Type as ValueType

__all__ = ["ValueType"]
