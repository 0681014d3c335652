"""Cell files with every table that there is."""

RIGHT = """
[cell]
name = "pallet cell"
[units]
length = "mm"
[robot]
model = "puma560"
base = { position = [100, 0, 0], rpy = [0, 0, 90] }
tool = "jaws"
speed_override = 0.8
start = [0, 90, 0, 0, 0, 0]
[controller]
path_speed = 150
kp = [20, 20, 20, 20, 20, 20]
[tools.jaws]
position = [0, 0, 120]
mass = 0.8
com = [0, 0, 60]
inertia = [0.001, 0.001, 0.0005, 0, 0, 0]
gripper = { open_time = 0.2, close_time = 0.2, capture = 5 }
[tools.cups]
part = { kind = "vacuum_gripper", model = "franka_cobot_pump", cups_x = 2, cup_diameter = 30, pitch = 60 }
parts = [{ name = "plate", part = { kind = "flange", thickness = 10 } }]
[frames.pallet]
position = [500, 200, 0]
quaternion = [1, 0, 0, 0]
[locations.corner]
frame = "pallet"
position = [10, 0, 0]
down = false
[[parts]]
name = "box"
size = [60, 60, 40]
mass = 0.5
position = [500, 0, 40]
grid = { counts = [2, 3], step = [[70, 0, 0], [0, 70, 0]] }
[[supplies]]
name = "crate"
size = [60, 60, 40]
mass = 0.5
position = [400, 0, 40]
count = 3
[[sinks]]
name = "bin"
position = [0, 500, 0]
radius = 50
[[objects]]
name = "table"
position = [500, 0, 0]
colour = "#8b959f"
material = "wood"
shapes = [{ box = [100, 100, 10], opacity = 0.5 }, { arc = { radius = 3, from = 0, to = 90 } }]
[[objects]]
name = "stand"
position = [500, 0, 0]
shapes = [{ prism = { outline = [[0, 0], [9, 0], [0, 9]], length = 4 } }, { revolve = [[0, 0], [9, 5]] }]
[[objects]]
name = "fence"
position = [500, 0, 0]
shapes = [{ line = [[0, 0, 0], [1, 0, 0]] }, { mesh = "geometry/fence.stl", scale = 0.001 }]
[[objects]]
name = "euro"
position = [900, 800, 0]
part = { kind = "eur_pallet", model = "eur_1", mass = 25 }
[signals.ready]
input = 1
changes = [[0.5, true], [1.5, false]]
[classic]
length = "cm"
frame = "pallet"
"""

STATIONS = """
[stations.left]
robot = "puma560"
tool = "jaws"
program = "left"
track = { length = 2000, carriage_mass = 200, speed = 999, acceleration = 2e3, mount = { rpy = [0, 0, 9] } }
start = [0, 75, -180, 0, -75, 0, 500]
[stations.left.controller]
control_hz = 500
in_position = [0.1, 0.1, 0.1, 0.1, 0.1, 0.1, 2]
[stations.right]
robot = "scara"
base = { position = [1200, 0, 0], rpy = [0, 0, 180] }
positioner = { radius = 300, height = 600, inertia = 20, base = { position = [2000, 0, 0] } }
tools = ["jaws", "pen"]
tool = "pen"
speed_override = 0.5
[tools.jaws]
position = [0, 0, 120]
gripper = {}
[tools.pen]
position = [0, 0, 80]
[locations.stock]
position = [500, 300, 600]
external = [500]
station = "left"
[devices.belt]
kind = "conveyor"
base = { position = [350, -1400, 500], rpy = [0, 0, 90] }
length = 1200
width = 200
height = 120
speed = 250
acceleration = 1000
run = "belt_on"
stop = { at = 1000, signal = "part_there" }
[devices.door]
kind = "slide"
size = [900, 30, 1200]
signal = "open_door"
off = 0
on = 900
speed = 800
acceleration = 2000
is_off = "closed"
is_on = "opened"
[devices.table]
kind = "turntable"
base = { position = [600, 600, 500] }
diameter = 500
height = 40
signal = "closed"
step = 90
speed = 120
acceleration = 400
in_place = "stands"
[devices.second]
kind = "conveyor"
part = { kind = "belt_conveyor", length = 1500, height = 600 }
base = { position = [350, 3000, 600] }
speed = 250
[devices.disc]
kind = "turntable"
part = { kind = "turntable", diameter = 500 }
base = { position = [3000, 600, 400] }
signal = "closed"
on = 90
speed = 120
acceleration = 400
[[objects]]
name = "fixture"
parent = "table"
position = [180, 0, 20]
size = [80, 80, 20]
[[parts]]
name = "post"
size = [40, 40, 160]
mass = 0.4
position = [350, -1000, 660]
[signals.belt_on]
output = 1
[signals.open_door]
output = 2
[signals.part_there]
input = 1
[signals.closed]
input = 2
[signals.opened]
input = 3
[signals.stands]
input = 4
"""

AXES = """
[stations.turner]
robot = "puma560"
tool = "jaws"
base = { position = [100, 0, 0], rpy = [0, 0, 10] }
track = { length = 2000, mount = { rpy = [0, 0, 90] } }
positioner = { radius = 300, height = 500, base = { position = [600, 700, 0] } }
start = [0, 75, -180, 0, -75, 0, 200, 30]
[stations.shuttle]
base = { position = [-600, 300, 500], rpy = [0, 0, 90] }
start = [200]
[stations.shuttle.mechanism]
kind = "slide"
low = 0
high = 900
mass = 15
size = [300, 200, 20]
speed = 800
acceleration = 2000
[stations.lift]
base = { position = [-600, -600, 100] }
[stations.lift.mechanism]
kind = "turntable"
low = -360
high = 360
inertia = 2
diameter = 400
speed = 180
acceleration = 400
[tools.jaws]
position = [0, 0, 120]
gripper = {}
[frames.fixture]
parent = "turner/positioner"
position = [0, 100, 20]
rpy = [0, 0, 90]
[frames.rack]
parent = "turner/track"
position = [300, 300, 200]
[locations.corner]
frame = "fixture"
position = [30, 0, 40]
[[objects]]
name = "nest"
parent = "turner/positioner"
position = [0, 100, 20]
size = [100, 100, 20]
[[objects]]
name = "tray"
parent = "shuttle"
position = [0, 0, 20]
size = [100, 100, 20]
[[parts]]
name = "box"
size = [40, 40, 40]
mass = 0.2
position = [-600, 500, 560]
"""
