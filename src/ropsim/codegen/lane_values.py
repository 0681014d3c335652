"""Vectors of eight numbers in straight-line code."""

from llvmlite import ir

from ropsim.codegen.instructions import REAL, Instructions

LANES = 8
"""Numbers in a vector; where a processor takes four at a time, LLVM makes two instructions of one."""
VECTOR = ir.VectorType(REAL, LANES)
_PLACE = ir.IntType(32)


class LaneValues(Instructions):
    """Lines whose values are vectors."""

    kind = VECTOR
    suffix = f"v{LANES}f64"

    def number(self, number: float) -> ir.Value:
        """Return a number in all lanes."""
        return ir.Constant(VECTOR, [number] * LANES)

    def lane(self, value: ir.Value, lane: int) -> ir.Value:
        """Return the number in one lane."""
        return self.builder.extract_element(value, ir.Constant(_PLACE, lane))

    def with_lane(self, value: ir.Value, lane: int, number: ir.Value) -> ir.Value:
        """Return a vector with another number in one lane."""
        return self.builder.insert_element(value, number, ir.Constant(_PLACE, lane))

    def spread(self, number: ir.Value) -> ir.Value:
        """Return a value in all lanes."""
        value = ir.Constant(VECTOR, ir.Undefined)
        for lane in range(LANES):
            value = self.with_lane(value, lane, number)
        return value
