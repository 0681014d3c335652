"""Queries about a text in units: declarations, signatures of tasks, and results of each body.

Each function is pure: the database records its dependencies, so that a change reaches only dependent results.
A task depends on its own text, on the declarations that it names and on the signatures of the tasks that it
calls; never on its callers, unless the text is a classic one, where calls of a task may determine types of
its parameters.
"""

from ropsim.language.questions.bodies import calls_of as calls_of
from ropsim.language.questions.bodies import checked as checked
from ropsim.language.questions.bodies_in import Bodies as Bodies
from ropsim.language.questions.bodies_in import all_forms as all_forms
from ropsim.language.questions.bodies_in import all_words as all_words
from ropsim.language.questions.bodies_in import bodies_in as bodies_in
from ropsim.language.questions.bodies_in import find_types as find_types
from ropsim.language.questions.bodies_in import found_in_headers as found_in_headers
from ropsim.language.questions.bodies_in import found_in_signatures as found_in_signatures
from ropsim.language.questions.bodies_in import own_tasks as own_tasks
from ropsim.language.questions.call_graph import circles_of as circles_of
from ropsim.language.questions.call_graph import uncalled_tasks as uncalled_tasks
from ropsim.language.questions.callers import is_own as is_own
from ropsim.language.questions.callers import order as order
from ropsim.language.questions.calls import form as form
from ropsim.language.questions.calls import joint_count as joint_count
from ropsim.language.questions.calls import signature as signature
from ropsim.language.questions.declarations import basics as basics
from ropsim.language.questions.declarations import declared as declared
from ropsim.language.questions.declarations import frame as frame
from ropsim.language.questions.declarations import names_in as names_in
from ropsim.language.questions.declarations import symbol as symbol
from ropsim.language.questions.groups import Group as Group
from ropsim.language.questions.groups import grouped as grouped
from ropsim.language.questions.groups import groups as groups
from ropsim.language.questions.groups import part_groups as part_groups
from ropsim.language.questions.headers import header as header
from ropsim.language.questions.inference import inference as inference
from ropsim.language.questions.inference import types as types
from ropsim.language.questions.inference import words as words
from ropsim.language.questions.inputs import BEFORE_CHECK as BEFORE_CHECK
from ropsim.language.questions.inputs import BEFORE_WALK as BEFORE_WALK
from ropsim.language.questions.inputs import BLOCK as BLOCK
from ropsim.language.questions.inputs import CONTROL_CALLS as CONTROL_CALLS
from ropsim.language.questions.inputs import CONTROL_LOCAL as CONTROL_LOCAL
from ropsim.language.questions.inputs import CONTROL_LOCALS as CONTROL_LOCALS
from ropsim.language.questions.inputs import DECLARED as DECLARED
from ropsim.language.questions.inputs import ENVIRONMENT as ENVIRONMENT
from ropsim.language.questions.inputs import INFERRED as INFERRED
from ropsim.language.questions.inputs import JOINT_COUNT as JOINT_COUNT
from ropsim.language.questions.inputs import LISTS as LISTS
from ropsim.language.questions.inputs import OF_PARTS as OF_PARTS
from ropsim.language.questions.inputs import ORDER as ORDER
from ropsim.language.questions.inputs import PART as PART
from ropsim.language.questions.inputs import PARTS as PARTS
from ropsim.language.questions.inputs import TASKS as TASKS
from ropsim.language.questions.inputs import TYPES as TYPES
from ropsim.language.questions.inputs import WALKED_CONTROL as WALKED_CONTROL
from ropsim.language.questions.parts import checked_in as checked_in
from ropsim.language.questions.parts import checked_part as checked_part
from ropsim.language.questions.parts import inferred_part as inferred_part
from ropsim.language.questions.parts import mentions as mentions
from ropsim.language.questions.parts import points as points
from ropsim.language.questions.parts import variables_of as variables_of
from ropsim.language.questions.parts import walked_in as walked_in
from ropsim.language.questions.told import inferred as inferred
