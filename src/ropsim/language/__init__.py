"""The task language: text to structured program and ICR, with a diagnostic for every wrong line."""

from ropsim.language.cache import LineCache as LineCache
from ropsim.language.compile import Compiled as Compiled
from ropsim.language.compile import compile as compile
from ropsim.language.environment import NO_SIGNATURES as NO_SIGNATURES
from ropsim.language.environment import Environment as Environment
from ropsim.language.environment import TaskSignature as TaskSignature
from ropsim.language.form import formatted as formatted
from ropsim.language.outline import Definition as Definition
from ropsim.language.outline import Outline as Outline
from ropsim.language.outline import Role as Role
from ropsim.language.outline import TaskOutline as TaskOutline
from ropsim.language.outline import outline as outline
from ropsim.language.places import named_at as named_at
from ropsim.language.prelude import goes_on as goes_on
from ropsim.language.prelude import prelude as prelude
from ropsim.language.task_form import ParameterForm as ParameterForm
from ropsim.language.task_form import TaskForm as TaskForm
from ropsim.language.vocabulary import BEHIND_TARGETS as BEHIND_TARGETS
from ropsim.language.vocabulary import FUNCTIONS as FUNCTIONS
from ropsim.language.vocabulary import INNER_WORDS as INNER_WORDS
from ropsim.language.vocabulary import LOCATION_WORDS as LOCATION_WORDS
from ropsim.language.vocabulary import MOTION_WORDS as MOTION_WORDS
from ropsim.language.vocabulary import STATEMENT_WORDS as STATEMENT_WORDS
from ropsim.language.vocabulary import TYPE_WORDS as TYPE_WORDS
from ropsim.language.vocabulary import UNIT_WORDS as UNIT_WORDS
