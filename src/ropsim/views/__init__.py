"""What people see of a run: summary, terminal report, HTML report, diagnostics as text."""

from ropsim.views.diagnostics import diagnostic_text as diagnostic_text
from ropsim.views.diagnostics import diagnostics_text as diagnostics_text
from ropsim.views.findings import FindingGroup as FindingGroup
from ropsim.views.findings import count_text as count_text
from ropsim.views.findings import group_findings as group_findings
from ropsim.views.header import JointFacts as JointFacts
from ropsim.views.header import RunHeader as RunHeader
from ropsim.views.html_report import html_report as html_report
from ropsim.views.joint_summary import Closeness as Closeness
from ropsim.views.joint_summary import JointSummary as JointSummary
from ropsim.views.joint_summary import LimitApproach as LimitApproach
from ropsim.views.path_summary import PathLine as PathLine
from ropsim.views.path_summary import PathMove as PathMove
from ropsim.views.path_summary import PathSummary as PathSummary
from ropsim.views.style import Style as Style
from ropsim.views.summary import Summary as Summary
from ropsim.views.summary import summarize as summarize
from ropsim.views.task_summary import TaskSummary as TaskSummary
from ropsim.views.terminal import terminal_report as terminal_report
from ropsim.views.verdict import Verdict as Verdict
from ropsim.views.verdict import VerdictText as VerdictText
from ropsim.views.verdict import verdict as verdict
