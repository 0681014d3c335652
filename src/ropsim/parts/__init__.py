"""Library of parts next to robots: grippers, flanges, conveyors, turntables, fences, pallets, tables."""

from ropsim.parts.catalogue import PART_KINDS as PART_KINDS
from ropsim.parts.catalogue import kinds_for as kinds_for
from ropsim.parts.catalogue import library_part as library_part
from ropsim.parts.catalogue import part_kind as part_kind
from ropsim.parts.diagnostics import CONFLICTING_MEASURES as CONFLICTING_MEASURES
from ropsim.parts.diagnostics import PartValueError as PartValueError
from ropsim.parts.diagnostics import UnknownPartError as UnknownPartError
from ropsim.parts.fingers import parallel_fingers as parallel_fingers
from ropsim.parts.fingers import shaped_fingers as shaped_fingers
from ropsim.parts.mounting import mounted as mounted
from ropsim.parts.part_kind import Fact as Fact
from ropsim.parts.part_kind import LibraryPart as LibraryPart
from ropsim.parts.part_kind import Measure as Measure
from ropsim.parts.part_kind import Origin as Origin
from ropsim.parts.part_kind import Parameter as Parameter
from ropsim.parts.part_kind import PartKind as PartKind
from ropsim.parts.part_kind import Product as Product
from ropsim.parts.part_kind import Use as Use
from ropsim.parts.part_kind import Values as Values
from ropsim.parts.words import fact_words as fact_words
from ropsim.parts.words import range_words as range_words
from ropsim.parts.words import value_words as value_words
from ropsim.parts.words import values_words as values_words
