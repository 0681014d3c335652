"""Code of the PID block."""

from ropsim import blockdiagram as b
from ropsim.controller.diagrams.static_blocks import spread
from ropsim.controller.diagrams.written import Written, total


def pid(block: b.Pid, to: Written) -> dict[int, str]:
    """Write a PID controller; see `blockdiagram.Pid` for its equations.

    The derivative is that of backward differences, the lag T_f of which has the pole T_f/(T_f + T).

    Returns:
        Where the integrals stand, by element.
    """
    inputs, results = to.inputs(block), to.results(block)
    references, measured, added = inputs[0], inputs[1], inputs[2] if len(inputs) > 2 else None
    size, period, integrals = len(results), block.sample_time, dict[int, str]()
    names = ("kp", "ki", "kd", "derivative_filter", "setpoint_weight", "derivative_weight")
    kp, ki, kd, lag, weight, slope = (spread(getattr(block, name), size) for name in names)
    lower, upper, tracking = (
        spread(one, size) if one else () for one in (block.lower, block.upper, block.tracking_time)
    )
    for k, y in enumerate(results):
        r, m, terms = references[k], measured[k], list[str]()
        if kp[k] != 0.0:
            terms.append(f"{to.number(kp[k])} * ({to.number(weight[k])} * {r} - {m})")
        if ki[k] != 0.0 or to.diagram.holding == block.name:
            integrals[k] = f"x[{to.memory(1)}]"
            to.before([f"if attempt == 0: {integrals[k]} = 0.0"])
            terms.append(integrals[k])
        if kd[k] != 0.0:
            terms.append(_derivative(to, (kd[k], lag[k], period), f"{to.number(slope[k])} * {r} - {m}"))
        if added is not None:
            terms.append(added[k])
        if not lower:
            to.outputs.append(f"{y} = {total(terms)}")
            if k in integrals:
                to.kept.append(f"{integrals[k]} += {to.number(ki[k] * period)} * ({r} - {m})")
            continue
        low, high, asked = to.number(lower[k]), to.number(upper[k]), to.local()
        to.outputs += [f"{asked} = {total(terms)}", f"{y} = min(max({asked}, {low}), {high})"]
        if k in integrals:
            step = f"{to.number(ki[k] * period)} * ({r} - {m})"
            if block.anti_windup is b.AntiWindup.CLAMPING:
                going = to.local()
                to.kept += [
                    f"{going} = {step}",
                    f"if not ({asked} > {high} and {going} > 0.0 or {asked} < {low} and {going} < 0.0):",
                    f"    {integrals[k]} += {going}",
                ]
                continue
            drawn = ""
            if block.anti_windup is b.AntiWindup.BACK_CALCULATION:
                drawn = f" + {to.number(period / tracking[k])} * ({y} - {asked})"
            to.kept.append(f"{integrals[k]} += {step}{drawn}")
    return integrals


def _derivative(to: Written, numbers: tuple[float, float, float], value: str) -> str:
    """Write the filtered derivative of a value and return its name."""
    gain, lag, period = numbers
    first, now, made = to.memory(2), to.local(), to.local()
    to.outputs.append(f"{now} = {value}")
    to.before([f"x[{first}] = {now}", f"x[{first + 1}] = 0.0"])
    pole, rate = to.number(lag / (lag + period)), to.number(gain / (lag + period))
    to.outputs.append(f"{made} = {pole} * x[{first + 1}] + {rate} * ({now} - x[{first}])")
    to.kept += [f"x[{first}] = {now}", f"x[{first + 1}] = {made}"]
    return made
