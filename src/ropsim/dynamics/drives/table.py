"""The blocks of all records that a drive can be made of: a new one is a file and an entry here."""

from ropsim.dynamics.drives.amplifiers import CURRENT_LIMITED, EFFORT, GUARDED, VALVE, VOLTAGE
from ropsim.dynamics.drives.backlash_gear import BACKLASH_GEAR
from ropsim.dynamics.drives.ball_screw import BALL_SCREW, STEADY_SCREW, SteadyScrew
from ropsim.dynamics.drives.block import (
    AmplifierBlock,
    FrictionBlock,
    LinkBlock,
    MotorBlock,
    TransmissionBlock,
)
from ropsim.dynamics.drives.current_loop import CURRENT_LOOP
from ropsim.dynamics.drives.dc_motor import DC_MOTOR
from ropsim.dynamics.drives.elastic_gear import ELASTIC_GEAR
from ropsim.dynamics.drives.frictions.coulomb import FRICTION
from ropsim.dynamics.drives.frictions.load import LOAD_FRICTION
from ropsim.dynamics.drives.frictions.lugre import LUGRE_FRICTION
from ropsim.dynamics.drives.frictions.stribeck import STRIBECK_FRICTION
from ropsim.dynamics.drives.gear import GEAR
from ropsim.dynamics.drives.hydraulics.cylinder import HYDRAULIC_CYLINDER
from ropsim.dynamics.drives.hydraulics.motor import HYDRAULIC_MOTOR
from ropsim.dynamics.drives.hydraulics.vane import HYDRAULIC_VANE
from ropsim.dynamics.drives.ideal_motor import IDEAL_MOTOR
from ropsim.dynamics.drives.lagging_motor import LAGGING_MOTOR
from ropsim.dynamics.drives.link_elasticity import LINK_ELASTICITY
from ropsim.dynamics.drives.linkage import LINKAGE
from ropsim.dynamics.drives.thermal_motor import THERMAL_MOTOR
from ropsim.model import (
    BacklashGear,
    BallScrew,
    CurrentLimitedAmplifier,
    CurrentLoopMotor,
    DcMotor,
    EffortAmplifier,
    ElasticGear,
    Friction,
    Gear,
    GuardedAmplifier,
    HydraulicCylinder,
    HydraulicMotor,
    HydraulicVane,
    IdealMotor,
    LaggingMotor,
    Linkage,
    LinkElasticity,
    LoadFriction,
    LugreFriction,
    StribeckFriction,
    ThermalDcMotor,
    ValveAmplifier,
    VoltageAmplifier,
)

AMPLIFIERS: dict[type, AmplifierBlock] = {
    VoltageAmplifier: VOLTAGE,
    CurrentLimitedAmplifier: CURRENT_LIMITED,
    GuardedAmplifier: GUARDED,
    EffortAmplifier: EFFORT,
    ValveAmplifier: VALVE,
}
MOTORS: dict[type, MotorBlock] = {
    DcMotor: DC_MOTOR,
    ThermalDcMotor: THERMAL_MOTOR,
    CurrentLoopMotor: CURRENT_LOOP,
    LaggingMotor: LAGGING_MOTOR,
    IdealMotor: IDEAL_MOTOR,
    HydraulicMotor: HYDRAULIC_MOTOR,
    HydraulicCylinder: HYDRAULIC_CYLINDER,
    HydraulicVane: HYDRAULIC_VANE,
}
TRANSMISSIONS: dict[type, TransmissionBlock] = {
    Gear: GEAR,
    ElasticGear: ELASTIC_GEAR,
    BacklashGear: BACKLASH_GEAR,
    Linkage: LINKAGE,
    BallScrew: BALL_SCREW,
    SteadyScrew: STEADY_SCREW,
}
LINKS: dict[type, LinkBlock] = {LinkElasticity: LINK_ELASTICITY}
FRICTIONS: dict[type, FrictionBlock] = {
    Friction: FRICTION,
    StribeckFriction: STRIBECK_FRICTION,
    LoadFriction: LOAD_FRICTION,
    LugreFriction: LUGRE_FRICTION,
}
