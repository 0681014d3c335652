"""The value types of the structured program: those of ICR."""

from ropsim.icr import Type as ValueType

__all__ = ["ValueType"]
