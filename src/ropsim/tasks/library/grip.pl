% Grip and release of the paper on the task language, Fig. 5.

task(grip(P, L), [
  doc("Takes the part at a location. Needs one reference location and the gripper open."),
  params([P-part, L-location]),
  words([
    word(P, "part", "the part that lies there"),
    word(L, "place", "where the part lies")]),
  pre([gripper(open), at(P, L)]),
  eff([-gripper(open), +gripper(closed), -at(P, L), +held(P), +free(L)]),
  geo([reachable(arm, L), collision_free(arm, P, L)]),
  body([mov(L), close])]).

task(release(P, L), [
  doc("Leaves the part that is held at a location. Needs one reference location and the gripper closed."),
  params([P-part, L-location]),
  words([
    word(P, "part", "the part in the gripper"),
    word(L, "place", "where the part is to lie")]),
  pre([gripper(closed), held(P), free(L)]),
  eff([-gripper(closed), +gripper(open), -held(P), +at(P, L), -free(L)]),
  geo([reachable(arm, L), collision_free(arm, P, L)]),
  body([mov(L), open])]).
