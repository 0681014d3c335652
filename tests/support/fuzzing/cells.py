"""A cell file with every table that there is."""

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
[signals.ready]
input = 1
changes = [[0.5, true], [1.5, false]]
[classic]
length = "cm"
frame = "pallet"
"""
