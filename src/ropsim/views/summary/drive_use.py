"""How far a run uses each drive: torque, current, speed and winding, against limits of its model."""

import math

from ropsim.core import frozen_dataclass
from ropsim.flow import AxisFacts
from ropsim.views.channels import Peak, StationView, rms
from ropsim.views.summary.energy_summary import POWER, both_energies
from ropsim.views.summary.joint_summary import share


@frozen_dataclass
class DriveUse:
    """The use of one drive in one run; NaN for quantities that it lacks.

    Shares refer to limits of the model. It has no limit of the lasting torque; one of the lasting current
    follows from the greatest rise of a winding where that is watched.

    Attributes:
        station: name of the station whose drive it is.
        name: of the joint, with several stations that of its station before it.
        facts: name, type and limits of the axis.
        effort_rms: root of the mean square of torque or force at the joint over the run [N·m | N].
        effort: its largest magnitude.
        current_rms: root of the mean square of the motor current [A].
        current: its largest magnitude.
        speed: largest speed of the joint [rad/s | m/s].
        rise: largest temperature of the winding over that of the surroundings [K].
        power: largest power that it draws [W].
        drawn: energy drawn, were it alone at its supply [J].
        given_back: energy given back [J], positive.
    """

    station: str
    name: str
    facts: AxisFacts
    effort_rms: float
    effort: Peak
    current_rms: float
    current: Peak
    speed: Peak
    rise: Peak
    power: Peak
    drawn: float
    given_back: float

    @property
    def effort_share(self) -> float:
        """Return the largest torque as a share of its limit; NaN where there is none, as of all shares."""
        return share(self.effort.size, self.facts.max_effort)

    @property
    def lasting_current_share(self) -> float:
        """Return the RMS current as a share of the current that the winding bears for ever."""
        return share(self.current_rms, self.facts.lasting_current)

    @property
    def current_share(self) -> float:
        """Return the largest current as a share of its limit."""
        return share(self.current.size, self.facts.max_current)

    @property
    def speed_share(self) -> float:
        """Return the largest speed as a share of its limit."""
        return share(self.speed.size, self.facts.max_speed)

    @property
    def rise_share(self) -> float:
        """Return the largest rise of the winding as a share of its limit."""
        return share(self.rise.size, self.facts.max_rise)


def summarize_drives(station: StationView) -> tuple[DriveUse, ...]:
    """Return the use of the drives of a station; nothing of an arm without drives."""
    if not station.is_driven:
        return ()
    names = ("tau", "current", "qd", "winding_rise", POWER)
    tau, current, speed, rise, power = map(station.joints, names)
    uses = []
    for k, facts in enumerate(station.facts.axes):
        drawn, given_back = both_energies(power[:, k], station.time)
        uses.append(
            DriveUse(
                station.facts.name,
                station.label(facts.name),
                facts,
                effort_rms=rms(tau[:, k]),
                effort=station.peak(tau[:, k]),
                current_rms=rms(current[:, k]),
                current=station.peak(current[:, k]),
                speed=station.peak(speed[:, k]),
                rise=station.peak(rise[:, k]),
                power=station.peak(power[:, k].clip(min=0.0)),
                drawn=float(drawn.sum()) if len(drawn) else math.nan,
                given_back=float(given_back.sum()) if len(given_back) else math.nan,
            )
        )
    return tuple(uses)
