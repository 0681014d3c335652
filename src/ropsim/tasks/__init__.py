"""Knowledge bases of tasks: what a robot can do, whether it can now, and what it has to do for a goal."""

from ropsim.tasks.base import KnowledgeBase as KnowledgeBase
from ropsim.tasks.call_report import CallReport as CallReport
from ropsim.tasks.clause_text import term_text as term_text
from ropsim.tasks.compiling import body_findings as body_findings
from ropsim.tasks.errors import TaskError as TaskError
from ropsim.tasks.geometry import Geometry as Geometry
from ropsim.tasks.known_task import KnownTask as KnownTask
from ropsim.tasks.known_task import Parameter as Parameter
from ropsim.tasks.not_defined import not_defined as not_defined
from ropsim.tasks.planning import Plan as Plan
from ropsim.tasks.program_text import program_text as program_text
from ropsim.tasks.task_call import Point as Point
from ropsim.tasks.task_call import Quantity as Quantity
from ropsim.tasks.task_call import TaskCall as TaskCall
from ropsim.tasks.task_call import Value as Value
from ropsim.tasks.task_text import stored_clause as stored_clause
from ropsim.tasks.task_text import task_text as task_text
from ropsim.tasks.world_state import WorldState as WorldState
