"""Composition of the cycle time of a station: parts, tasks, source lines, the limits that set it."""

from ropsim.views.cycle.cycle_time import CycleTime as CycleTime
from ropsim.views.cycle.cycle_time import summarize_cycle as summarize_cycle
from ropsim.views.cycle.line_cycle import CriticalShare as CriticalShare
from ropsim.views.cycle.line_cycle import LineCycle as LineCycle
from ropsim.views.cycle.line_cycle import TaskCycle as TaskCycle
from ropsim.views.cycle.parts import CycleParts as CycleParts
from ropsim.views.cycle.parts import Kind as Kind
