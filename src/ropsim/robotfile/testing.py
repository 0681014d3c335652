"""Door for tests: names behind the front of the package. Production code does not import it."""

from ropsim.robotfile.estimation.accelerations import accelerations as accelerations
from ropsim.robotfile.estimation.accelerations import full_accelerations as full_accelerations
from ropsim.robotfile.estimation.joint_centres import joint_centres as joint_centres
from ropsim.robotfile.estimation.joint_friction import joint_frictions as joint_frictions
from ropsim.robotfile.estimation.link_masses import bodies as bodies
from ropsim.robotfile.estimation.link_masses import cylinder as cylinder
from ropsim.robotfile.estimation.link_masses import extended_length as extended_length
from ropsim.robotfile.estimation.link_masses import heaviness as heaviness
from ropsim.robotfile.estimation.link_masses import link_masses as link_masses
from ropsim.robotfile.estimation.link_masses import link_masses_of_moving as link_masses_of_moving
from ropsim.robotfile.estimation.link_masses import total_mass as total_mass
from ropsim.robotfile.estimation.loads import axis_loads as axis_loads
from ropsim.robotfile.estimation.loads import gravity_torques as gravity_torques
from ropsim.robotfile.estimation.recognition import arm_class_of as arm_class_of
from ropsim.robotfile.estimation.rotors import rotors_at_joints as rotors_at_joints
from ropsim.robotfile.estimation.torque_limits import are_stand_ins as are_stand_ins
from ropsim.robotfile.estimation.torque_limits import torques_by_rule as torques_by_rule
