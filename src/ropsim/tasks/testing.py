"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.tasks.base import library_texts as library_texts
from ropsim.tasks.bodies.believed import Believed as Believed
from ropsim.tasks.bodies.believed import Held as Held
from ropsim.tasks.bodies.believed import Path as Path
from ropsim.tasks.bodies.body_terms import body_terms as body_terms
from ropsim.tasks.bodies.body_text import body_lines as body_lines
from ropsim.tasks.findings.words import KINDS as KINDS
from ropsim.tasks.host import SOURCES as SOURCES
from ropsim.tasks.terms import conditions as conditions
from ropsim.tasks.terms.conditions import CONDITIONS as CONDITIONS
from ropsim.tasks.terms.conditions import Condition as Condition
from ropsim.tasks.terms.conditions import examples as examples
from ropsim.tasks.terms.conditions import forms as forms
from ropsim.tasks.terms.expression_terms import NoTermError as NoTermError
from ropsim.tasks.terms.expression_text import NotTextError as NotTextError
from ropsim.tasks.terms.pattern import neighbours as neighbours
from ropsim.tasks.terms.pattern import places_in_rows as places_in_rows
from ropsim.tasks.terms.point import point_of_term as point_of_term
from ropsim.tasks.terms.point import term_of_point as term_of_point
from ropsim.tasks.terms.point import typed_point as typed_point
from ropsim.tasks.world.point_files import decoded as decoded
from ropsim.tasks.world.point_list import points_of as points_of
from ropsim.tasks.world.point_list import points_text as points_text
from ropsim.tasks.world.world_state import ordered as ordered
