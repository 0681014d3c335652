"""Projects: open, compile, simulate, report. The façade that every front end uses."""

from ropsim.workbench.calibrated_project import CalibratedProject as CalibratedProject
from ropsim.workbench.checked_text import CheckedText as CheckedText
from ropsim.workbench.checked_text import check_text as check_text
from ropsim.workbench.compiled_project import CompiledProgram as CompiledProgram
from ropsim.workbench.compiled_project import CompiledProject as CompiledProject
from ropsim.workbench.compiled_project import compile_program as compile_program
from ropsim.workbench.compiled_project import found_in as found_in
from ropsim.workbench.environment import environment_of as environment_of
from ropsim.workbench.example_projects import STARTER as STARTER
from ropsim.workbench.example_projects import example_names as example_names
from ropsim.workbench.example_projects import example_summary as example_summary
from ropsim.workbench.example_projects import new_project as new_project
from ropsim.workbench.opening import open_project as open_project
from ropsim.workbench.overlay import open_overlaid as open_overlaid
from ropsim.workbench.project import FailedRunError as FailedRunError
from ropsim.workbench.project import Project as Project
from ropsim.workbench.project import ProjectError as ProjectError
from ropsim.workbench.project_diagnostics import NOT_WRITABLE as NOT_WRITABLE
from ropsim.workbench.replay import pack_of as pack_of
from ropsim.workbench.what_if import Change as Change
from ropsim.workbench.what_if import Subject as Subject
from ropsim.workbench.what_if import WhatIfError as WhatIfError
from ropsim.workbench.what_if import read_change as read_change
