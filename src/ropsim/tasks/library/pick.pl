% Taking and leaving parts from above.

task(pick(P, L, Clear), [
  doc("Takes the part at a location from above, with a clearance before and after."),
  params([P-part, L-location, Clear-length = 50*mm]),
  words([
    word(P, "part", "the part that lies there"),
    word(L, "place", "where the part lies"),
    word(Clear, "clearance", "how far above the place the tool comes and goes")]),
  range([Clear >= 0*mm]),
  pre([gripper(open), at(P, L)]),
  eff([-gripper(open), +gripper(closed), -at(P, L), +held(P), +free(L)]),
  geo([reachable(arm, L), collision_free(arm, P, L)]),
  body([mov(above(L, Clear)), lin(L), close, lin(above(L, Clear))])]).

task(place(P, L, Clear), [
  doc("Leaves the part that is held at a location from above, with a clearance before and after."),
  params([P-part, L-location, Clear-length = 50*mm]),
  words([
    word(P, "part", "the part in the gripper"),
    word(L, "place", "where the part is to lie"),
    word(Clear, "clearance", "how far above the place the tool comes and goes")]),
  range([Clear >= 0*mm]),
  pre([gripper(closed), held(P), free(L)]),
  eff([-gripper(closed), +gripper(open), -held(P), +at(P, L), -free(L)]),
  geo([reachable(arm, L), collision_free(arm, P, L)]),
  body([mov(above(L, Clear)), lin(L), open, lin(above(L, Clear))])]).

task(insert(P, L, V), [
  doc("Puts the part that is held into its seat, slowly."),
  params([P-part, L-location, V-speed = 20*mm/s]),
  words([
    word(P, "part", "the part in the gripper"),
    word(L, "seat", "where the part is when it is home"),
    word(V, "speed", "how fast the part goes in")]),
  range([V > 0*mm/s]),
  pre([gripper(closed), held(P), free(L)]),
  eff([-gripper(closed), +gripper(open), -held(P), +at(P, L), -free(L), +inserted(P)]),
  geo([reachable(arm, L), collision_free(arm, P, L)]),
  body([mov(above(L, 30*mm)), lin(L, [speed(V), fine]), open, lin(above(L, 30*mm))])]).
goal(inserted/1).

task(move_over(L, Height), [
  doc("Brings the tool over a location."),
  params([L-location, Height-length = 50*mm]),
  words([
    word(L, "place", "over which the tool is to be"),
    word(Height, "height", "how far above the place")]),
  pre([]),
  eff([]),
  geo([reachable(arm, L)]),
  body([mov(above(L, Height))])]).

task(park(L), [
  doc("Brings the arm to where it is in nobody's way."),
  params([L-location]),
  words([word(L, "place", "where the arm is in nobody's way")]),
  eff([+parked(L)]),
  geo([reachable(arm, L)]),
  body([mov(L)])]).
goal(parked/1).
