"""The law of hydraulic axes that knows flow, load and damping.

A valve sets a flow, so the law asks which flow the wanted motion takes (H. E. Merritt: Hydraulic Control
Systems, Wiley 1967; M. Jelali, A. Kroll: Hydraulic Servo-systems, Springer 2003, chapters 4 and 5). The force
F of the wanted motion is that of the model with its load. With the spring of the oil k = β·(A_a²/V_a +
A_b²/V_b) a rod that goes at v while F changes takes as much flow as one at v + F'/k. The opening for it
depends on the pressures that the motion has then. The force leaves one of them open, which follows from what
has flown: it runs along in the law by the equation of its chamber. The lag of the valve is made up for by a
lead. What is left of the error goes through a PI loop, and the swing on the oil is damped by the measured
force: the valve gives way by kd/k for each newton beyond the wanted force, except for what lasts. Where an
axis with its load swings slowly, on short levers, these loops are slower by as much.
"""

import numpy as np

from ropsim.controller.hydraulics.valve_rows import valve_rows
from ropsim.controller.law import CompiledLaw, LawTraits
from ropsim.controller.law_gains import gain_rows
from ropsim.controller.law_model import law_model
from ropsim.model import ControllerModel, FlowGains, InputKind, Mechanism, gain_names

SOURCE = """\
def law(par, state, ref, meas, sensed, model, work, load, out):
    inverse(model, ref[0], ref[1], ref[2], load, work[effort])
    inertias(model, ref[0], load, work[inertia])
    transmission(model, ref[0], work[ratio], work[slope], work[place])
    for j in range(out.shape[0]):
        period = par[period, j]
        area_a = par[area_a, j]
        area_b = par[area_b, j]
        high = par[supply, j]
        low = par[drain, j]
        edge = par[edge, j]
        ratio = work[ratio, j]
        turned = min(max(work[place, j] - par[first, j], 0.0), par[stroke, j])
        soft_a = par[bulk, j] / (par[dead_a, j] + par[grow_a, j] * turned)
        soft_b = par[bulk, j] / (par[dead_b, j] + par[grow_b, j] * (par[stroke, j] - turned))
        spring = soft_a * area_a * area_a + soft_b * area_b * area_b
        wanted = work[effort, j] / ratio
        rod = ratio * ref[1, j]
        begins = state[begun, j] < 0.5
        if begins:
            state[force, j] = wanted
            other = (high + low - wanted / area_a) / (1.0 + area_b / area_a)
            state[pressure, j] = (wanted + area_b * other) / area_a
        rise = (wanted - state[force, j]) / period
        state[force, j] = wanted

        a = state[pressure, j]
        b = (area_a * a - wanted) / area_b
        leak = par[leakage, j] * (a - b)
        need = spring * (rod + rise / spring) + (soft_a * area_a + soft_b * area_b) * leak
        above_a = math.sqrt(max(high - a, 1e5))
        below_a = math.sqrt(max(a - low, 1e5))
        above_b = math.sqrt(max(high - b, 1e5))
        below_b = math.sqrt(max(b - low, 1e5))
        out_a = edge * (soft_a * area_a * above_a + soft_b * area_b * below_b)
        out_b = edge * (soft_a * area_a * below_a + soft_b * area_b * above_b)
        gain = out_a if need >= 0.0 else out_b
        opened = need / gain
        least = par[null, j]
        if least > 0.0:
            for _ in range(4):
                there = max(opened, 0.0) + least * least / (least + max(-opened, 0.0))
                back = max(-opened, 0.0) + least * least / (least + max(opened, 0.0))
                steeper = (least / (least + abs(opened))) ** 2
                slope = out_a + steeper * out_b if opened >= 0.0 else out_b + steeper * out_a
                opened -= (there * out_a - back * out_b - need) / slope
            gain = slope
        there = max(opened, 0.0)
        back = max(-opened, 0.0)
        if least > 0.0:
            there += least * least / (least + back)
            back += least * least / (least + max(opened, 0.0))
        into = edge * (there * above_a - back * below_a)
        steep = soft_a * (edge * (0.5 * there / above_a + 0.5 * back / below_a) + par[leakage, j])
        state[pressure, j] += soft_a * (into - area_a * rod - leak) * period / (1.0 + steep * period)
        state[pressure, j] = min(max(state[pressure, j], low + 1e5), high - 1e5)

        swing = abs(ratio) * math.sqrt(spring / work[inertia, j])
        share = min(1.0, par[swing, j] * swing / par[kp, j]) if par[kp, j] > 0.0 else 1.0
        found = area_a * sensed[pressure_a, j] - area_b * sensed[pressure_b, j] - wanted
        if begins:
            state[steady, j] = found
        state[steady, j] += (found - state[steady, j]) * share * par[corner, j] * period
        give = share * par[kd, j] / spring * (found - state[steady, j])
        error = ratio * (ref[0, j] - meas[0, j])
        rated = par[rated, j]
        if begins:
            state[forward, j] = opened
            state[held, j] -= par[sense, j] * rated * opened
        state[begun, j] = 1.0
        ahead = par[lead, j] * (opened - state[forward, j]) / period
        state[forward, j] = opened
        each = spring / gain
        open = opened + ahead + each * (share * par[kp, j] * error - give)
        open += par[sense, j] * state[held, j] / rated
        if abs(open) * rated < par[limit, j]:
            state[held, j] += par[sense, j] * rated * each * share * share * par[ki, j] * error * period
        lap = par[overlap, j]
        if lap > 0.0:
            open = (1.0 - lap) * open + lap * min(max(open / LAP, -1.0), 1.0)
        out[j] = par[sense, j] * rated * open
"""
STATES = ("held", "force", "pressure", "steady", "forward", "begun")
WORK = ("effort", "inertia", "ratio", "slope", "place")


def flow_load_damping(model: ControllerModel, robot: Mechanism) -> CompiledLaw:
    """Return the law of flow, load and damping of a controller; see `model.FlowGains` for its equations.

    Args:
        model: its gains and control period.
        robot: the arm as the law believes it to be; all its drives are hydraulic, with gears that are rigid.

    Raises:
        GainError: the gains belong to another law, or do not have a number per axis.
        JointCountError: links or drives are missing.
        MechanismError: the mechanism cannot be.
    """
    n = robot.n
    rows = dict(zip(gain_names(model.gains), gain_rows(model, FlowGains, n), strict=True))
    rows |= {"period": np.full(n, model.rates.control_period), **valve_rows(robot)}
    return CompiledLaw(
        name="flow_load_damping",
        source=SOURCE.replace("LAP", repr(SMOOTHED)),
        parameter_names=tuple(rows),
        parameters=np.stack(list(rows.values())),
        traits=LawTraits(
            InputKind.CURRENT, state_names=STATES, hold_row=0, sensed=("pressure_a", "pressure_b")
        ),
        model=law_model(robot),
        work_names=WORK,
    )


SMOOTHED = 0.02
"""Opening beyond the overlap from which on all of it is made up for: a jump at the centre would chatter."""
