"""All operations: instructions that reach beyond the stack."""

from ropsim.icr.operations_control import CONTROL
from ropsim.icr.operations_io import IO
from ropsim.icr.operations_modal import MODAL
from ropsim.icr.operations_motion import MOTION

OPERATIONS = CONTROL | MODAL | MOTION | IO
"""Mnemonic -> operation."""
