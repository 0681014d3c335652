"""Generated code: traced expressions, straight-line source, compiled and cached modules."""

from ropsim.codegen.caller import Compiled as Compiled
from ropsim.codegen.caller import StoppedError as StoppedError
from ropsim.codegen.caller import bound as bound
from ropsim.codegen.emit import Bounds as Bounds
from ropsim.codegen.emit import SourceFunction as SourceFunction
from ropsim.codegen.emit import emit as emit
from ropsim.codegen.emit import row_by_row as row_by_row
from ropsim.codegen.engine import Engine as Engine
from ropsim.codegen.engine import default_engine as default_engine
from ropsim.codegen.given_code import Formula as Formula
from ropsim.codegen.given_code import GivenCode as GivenCode
from ropsim.codegen.hoist import CONSTANTS as CONSTANTS
from ropsim.codegen.hoist import Hoisted as Hoisted
from ropsim.codegen.hoist import given as given
from ropsim.codegen.hoist import hoisted as hoisted
from ropsim.codegen.kernel import kernel as kernel
from ropsim.codegen.kernel import numba_available as numba_available
from ropsim.codegen.load import load as load
from ropsim.codegen.tracer import Scalar as Scalar
from ropsim.codegen.tracer import Tracer as Tracer
from ropsim.codegen.tracer import cos as cos
from ropsim.codegen.tracer import maximum as maximum
from ropsim.codegen.tracer import minimum as minimum
from ropsim.codegen.tracer import sin as sin
from ropsim.codegen.tracer import sqrt as sqrt
from ropsim.codegen.tracer import tanh as tanh
