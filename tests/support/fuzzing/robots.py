"""Robot files with every key that there is, one to a line."""

from support.robot_files import PUMA560, TWO_JOINTS

EVERYTHING = """
title = "everything"
convention = "modified"
source = "nobody"
home = [0, 30, 200]
mass = 40
gravity = [0, 0, -9.81]
reach = 900
origins = [{ parameters = "all", kind = "estimated", source = "by eye" }]
[units]
length = "mm"
angle = "deg"
[base]
position = [0, 0, 50]
rpy = [0, 0, 90]
shapes = [{ cylinder = { radius = 90, length = 50 } }, { capsule = { radius = 9, length = 0 } }]
[flange]
position = [0, 0, 90]
quaternion = [1, 0, 0, 0]
[[joints]]
name = "turn"
type = "revolute"
a = 10
alpha = 0
d = 400
theta = 0
limits = [-170, 170]
speed = 120
acceleration = 500
jerk = 5000
effort = 300
[[joints]]
alpha = -90
a = 50
limits = { turns = [-0.3, 0.25] }
[[joints]]
type = "prismatic"
alpha = 90
d = 20
limits = [100, 600]
speed = 900
[[links]]
mass = 12
com = [0, 0, -100]
inertia = [0.2, 0.2, 0.1, 0, 0, 0.01]
colour = "#d99a3d"
opacity = 0.8
material = "steel"
[[links]]
shapes = [{ box = [400, 90, 90], position = [200, 0, 0] }]
[[links]]
mass = 3
shapes = [{ mesh = "geometry/slide.stl", scale = 0.001 }]
[[drives]]
kind = "dc"
ratio = 80
torque_constant = 0.1
back_emf_constant = 0.1
resistance = 1.5
inductance = 2e-3
rotor_inertia = 1e-4
max_voltage = 48
max_current = 12
limits_current = true
viscous = 1e-4
coulomb = [0.02, 0.03]
smoothing_speed = 0.01
[[drives]]
kind = "servo"
ratio = -100
max_torque = 2
stiffness = 2e4
damping = 10
coulomb = 0.02
[[drives]]
kind = "servo"
ratio = 314
rotor_inertia = 5e-5
"""

FRAMES = """
title = "frames"
convention = "frames"
axes = ["left", "right"]
home = [113, 53]
class = "industrial"
payload = 3
[flange]
on = "left elbow"
position = [450, 0, 0]
[[joints]]
name = "left"
position = [-200, 0, 0]
limits = [-170, 170]
speed = 120
acceleration = 500
jerk = 5000
effort = 300
[[joints]]
name = "left elbow"
position = [350, 0, 0]
limits = [-166, -6]
[[joints]]
name = "right"
on = "base"
position = [200, 0, 0]
rpy = [0, 0, 0]
offset = 0
limits = "endless"
[[joints]]
name = "right elbow"
position = [350, 0, 0]
[[joints]]
name = "ball"
type = "spherical"
on = "right"
quaternion = [1, 0, 0, 0]
[[joints]]
name = "spindle"
type = "screw"
on = "left"
lead = 5
follows = { left = 2, right = -0.5 }
follows_from = 0.1
[[links]]
mass = 2
com = [100, 0, 0]
inertia = [0.02, 0.02, 0.02, 0, 0, 0]
shapes = [{ box = [400, 40, 40], position = [200, 0, 0] }]
[[links]]
mass = 1
[[links]]
[[links]]
[[links]]
[[links]]
[[loops]]
first = { on = "left elbow", position = [450, 0, 0] }
second = { on = "right elbow", position = [450, 0, 0] }
holds = ["x", "y"]
[[loops]]
first = { on = "base", position = [200, 0, 0] }
second = { on = "ball", rpy = [0, 0, 10] }
joint = "fixed"
[[springs]]
name = "balance"
first = { on = "base", point = [100, 200, 300] }
second = { on = "right", point = [0, -100, 50] }
stiffness = 20000
free_length = 300
damping = 50
[[joint_springs]]
name = "back"
joint = "ball"
coordinate = 2
stiffness = 30
rest = 10
damping = 0.5
"""

ARMS = tuple(text.encode() for text in (EVERYTHING, PUMA560, TWO_JOINTS, FRAMES))
