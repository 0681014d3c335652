"""The task language: text to structured program and ICR, with a diagnostic for every wrong line."""

from ropsim.language.compile import Compiled as Compiled
from ropsim.language.compile import compile as compile
from ropsim.language.environment import NO_SIGNATURES as NO_SIGNATURES
from ropsim.language.environment import Environment as Environment
from ropsim.language.environment import TaskSignature as TaskSignature
