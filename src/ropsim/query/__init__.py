"""Incremental computation: inputs, pure functions of them with cached results, and their dependencies."""

from ropsim.query.content import is_same as is_same
from ropsim.query.database import Database as Database
from ropsim.query.database import always_new as always_new
from ropsim.query.event import Event as Event
from ropsim.query.event import Outcome as Outcome
from ropsim.query.once import Once as Once
from ropsim.query.splice import NOTHING_UNCHANGED as NOTHING_UNCHANGED
from ropsim.query.splice import Splice as Splice
from ropsim.query.splice import splice as splice
