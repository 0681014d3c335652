"""All operations: instructions that reach beyond the stack."""

from ropsim.icr.operations.control import CONTROL
from ropsim.icr.operations.io import IO
from ropsim.icr.operations.modal import MODAL
from ropsim.icr.operations.motion import MOTION
from ropsim.icr.operations.sensing import SENSING

OPERATIONS = CONTROL | MODAL | MOTION | IO | SENSING
"""Mnemonic -> operation."""
