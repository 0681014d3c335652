% Machines that the arm serves. Cells have the input machine_ready and the output chuck.

task(load_machine(P, M, L), [
  doc("Puts the part that is held into the chuck of a machine."),
  params([P-part, M-device, L-location]),
  words([
    word(P, "part", "the part in the gripper"),
    word(M, "machine", "the one that has its chuck there"),
    word(L, "chuck", "where the part is in the chuck")]),
  pre([gripper(closed), held(P), chuck_of(M, L), empty(M)]),
  eff([-gripper(closed), +gripper(open), -held(P), -empty(M), +loaded(P, M)]),
  geo([reachable(arm, L), collision_free(arm, P, L)]),
  body([
    wait_until(machine_ready, 60*s),
    mov(above(L, 100*mm)), lin(L), set(chuck, on), wait(0.3*s), open, lin(above(L, 100*mm))])]).
given(chuck_of/2).

task(unload_machine(P, M, L), [
  doc("Takes the part out of the chuck of a machine that is ready."),
  params([P-part, M-device, L-location]),
  words([
    word(P, "part", "the part in the chuck"),
    word(M, "machine", "the one that has its chuck there"),
    word(L, "chuck", "where the part is in the chuck")]),
  pre([gripper(open), loaded(P, M), chuck_of(M, L)]),
  eff([-gripper(open), +gripper(closed), +held(P), +empty(M), -loaded(P, M)]),
  geo([reachable(arm, L)]),
  body([
    wait_until(machine_ready, 60*s),
    mov(above(L, 100*mm)), lin(L), close, set(chuck, off), wait(0.3*s), lin(above(L, 100*mm))])]).
