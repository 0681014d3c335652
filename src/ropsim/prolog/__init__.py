"""SWI-Prolog inside the Python process: knowledge bases are checked, loaded and queried, and call Python."""

from ropsim.prolog.answers import Answer as Answer
from ropsim.prolog.answers import Answers as Answers
from ropsim.prolog.clauses import Places as Places
from ropsim.prolog.clauses import findings_of as findings_of
from ropsim.prolog.engine import Engine as Engine
from ropsim.prolog.errors import GoalError as GoalError
from ropsim.prolog.limits import Limits as Limits
from ropsim.prolog.preparation import Preparation as Preparation
from ropsim.prolog.program import Prolog as Prolog
from ropsim.prolog.terms.predicate import Predicate as Predicate
from ropsim.prolog.terms.predicate import Sort as Sort
from ropsim.prolog.terms.predicate import question as question
from ropsim.prolog.terms.reading import UnreadableError as UnreadableError
from ropsim.prolog.terms.reading import read_term as read_term
from ropsim.prolog.terms.terms import Atom as Atom
from ropsim.prolog.terms.terms import Struct as Struct
from ropsim.prolog.terms.terms import Term as Term
from ropsim.prolog.terms.terms import Var as Var
from ropsim.prolog.terms.terms import leaves as leaves
from ropsim.prolog.terms.texts import Trust as Trust
from ropsim.prolog.terms.writing import write_term as write_term
