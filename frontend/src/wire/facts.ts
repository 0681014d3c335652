/**
 * Facts of a recording about its run: stations and programs, arms, limits.
 *
 * Written by `tools/wire_types.py` from `ropsim.flow.facts`: change the records there.
 */

/** One change of an input. */
export interface InputChange {
  /** From when on it holds [s of simulated time]. */
  readonly time: number
  /** Name of an input of the cell. */
  readonly signal: string
  /** 0 or 1, or any number for an analog one. */
  readonly value: number
}

/** One change of the override, at which all motions of a run are followed. */
export interface OverrideChange {
  /** Of the control tick from which on it holds [s of simulated time]. */
  readonly time: number
  /** Share of the planned speed, 0 (held) to 1; below `SLOWEST` it counts as 0. */
  readonly value: number
}

/** The parts that have a destination in the cell. */
export interface Destinations {
  /** Required number. */
  readonly wanted: number
  /** How many of them are there when the run ends. */
  readonly reached: number
}

/** How the equations of drives and arm were integrated. */
export interface IntegrationFacts {
  /** Name of the method. */
  readonly method: string
  /** The integration step [s]. */
  readonly step: number
  /** What set it. */
  readonly cause: 'longest step' | 'fastest pole' | 'steepest friction' | 'stated' | 'most steps'
  /** The fastest rate of drives and arm, friction at the largest effort included, to four digits [1/s]. */
  readonly pole: number
  /**
   * By how much a coordinate differs at most from steps of half the length, rounded up to one digit [rad |
   * m], over a jolt of every axis at the start; null where it was not measured.
   */
  readonly error: number | null
}

/** Name, type and limits of one driven axis. */
export interface AxisFacts {
  /** Such as `1`. */
  readonly name: string
  /** Revolute or prismatic. */
  readonly type: 'revolute' | 'prismatic'
  /** Lower limit of the coordinate [rad | m]; null where unknown. */
  readonly lower: number | null
  /** Upper limit [rad | m]; null where unknown. */
  readonly upper: number | null
  /** [rad/s | m/s]; null where unknown. */
  readonly max_speed: number | null
  /** Torque or force at the joint [N·m | N]; null where unknown. */
  readonly max_effort: number | null
  /** Of the amplifier or the current loop [A]; null where unknown. */
  readonly max_current: number | null
  /** Which the winding bears for ever [A]; null where unknown. */
  readonly lasting_current: number | null
  /** Of the winding over the surroundings [K]; null where unknown. */
  readonly max_rise: number | null
}

/** Where a group of parameters comes from. */
export interface ParameterOrigin {
  /** Covered parameters, such as `motor constants`. */
  readonly parameters: string
  /** How they are known. */
  readonly kind: 'measured' | 'published' | 'derived' | 'estimated'
  /** Paper, table or reasoning. */
  readonly source: string
}

/** A task of a knowledge base that a program calls, or that another such task calls. */
export interface CalledTask {
  /** Its name. */
  readonly name: string
  /** Name of its text, such as `kb/glue.pl`. */
  readonly source: string
  /** SHA-256 of its task text, as 64 digits. */
  readonly version: string
}

/** One robot with its controller and the program that it ran. */
export interface StationFacts {
  /** Of the station; `robot` is that of the only one of a cell. */
  readonly name: string
  /** Name of the program; empty where it followed references of no program. */
  readonly program: string
  /** Name of the text whose lines the channel `line` counts. */
  readonly source: string
  /** Identity of the compiled program. */
  readonly icr_id: string
  /** Name of the joint controller; empty for a run without drives. */
  readonly law: string
  /** Rate of the joint controller [Hz]; null where unknown. */
  readonly control_hz: number | null
  /** Control ticks per interpolation tick. */
  readonly interpolation_ticks: number
  /** Integration steps of drives and arm per control tick. */
  readonly plant_steps: number
  /**
   * How drives and arm were integrated; null where nothing was: in a kinematic run, and in recordings of
   * older versions.
   */
  readonly integration: IntegrationFacts | null
  /** Short name of the robot. */
  readonly robot: string
  /** Its maker and model. */
  readonly title: string
  /** Of the robot, in the order of the columns of `q`. */
  readonly axes: readonly AxisFacts[]
  /** Where the parameters of robot and controller come from. */
  readonly origins: readonly ParameterOrigin[]
  /** How many moves were refused and left out. */
  readonly skipped_moves: number
  /** The tasks of knowledge bases that its program is made of. */
  readonly called: readonly CalledTask[]
}

/** How near two bodies came at the least in a run. */
export interface Clearance {
  /** Name of a body. */
  readonly one: string
  /** Name of the other one. */
  readonly other: string
  /** Between them [m]; negative: depth of a penetration; 0 where they touch. */
  readonly distance: number
  /** When [s]. */
  readonly time: number
  /** Whose arm it was; empty for none. */
  readonly station: string
  /** Its source line then, from 1; 0 for none. */
  readonly line: number
}

/** Two bodies. */
export interface BodyPair {
  /** Name of a body. */
  readonly one: string
  /** Name of the other one. */
  readonly other: string
}

/** Two bodies that penetrate each other, or come nearer than the cell allows, without a break. */
export interface Contact {
  /** Name of a body; the one that moves, if only one does. */
  readonly one: string
  /** Name of the other one. */
  readonly other: string
  /** First recorded time of it [s]. */
  readonly begin: number
  /** Last recorded time of it [s]. */
  readonly end: number
  /** Least distance in between [m]; negative: the depth of the penetration. */
  readonly distance: number
  /** When that was [s]. */
  readonly time: number
  /** Where that was, in the world frame [m], three numbers. */
  readonly place: readonly number[]
  /** Names of the two in findings, such as `jaws – pallet`; a part of a supply by the name of that. */
  readonly bodies: string
  /** Whose arm it was; empty for none. */
  readonly station: string
  /** Its source line at the beginning, from 1; 0 for none. */
  readonly line: number
  /** Loop pass of that line, from 1; 0 where unknown. */
  readonly visit: number
}

/** Contacts and the least distance of a run, and omitted checks. */
export interface WayFacts {
  /**
   * Least distance of the run, bodies of one robot against each other left out; null where nothing moved
   * against anything.
   */
  readonly clearance: Clearance | null
  /** Names of bodies without a known shape. */
  readonly unseen: readonly string[]
  /** Pairs that are drawn into each other, or parts that are in something at the start. */
  readonly met: readonly BodyPair[]
  /** Penetrations, in order of time. */
  readonly contacts: readonly Contact[]
  /** Bodies that came nearer than the cell requires, in order of time. */
  readonly near: readonly Contact[]
  /** Clearance that the cell requires [m]; 0 for none. */
  readonly required: number
  /** Bodies of these contacts that count without their hollows: meshes, rings and cups. */
  readonly filled: readonly string[]
  /**
   * Bodies so near that recorded rows do not tell whether they penetrate, in order of time; their distance is
   * the depth that cannot be excluded.
   */
  readonly undecided: readonly Contact[]
}

/** Programs, stations and settings of a run. */
export interface RunFacts {
  /** Version that made the run. */
  readonly ropsim: string
  /** Name of the project. */
  readonly project: string
  /** With drives and masses or without. */
  readonly fidelity: 'dynamic' | 'kinematic'
  /** Recorded rows per second [Hz]; null where unknown. */
  readonly record_hz: number | null
  /**
   * Checks of the run in addition to motion, limits and, with drives, torques, drives and servo, such as
   * `collisions`.
   */
  readonly checked: readonly string[]
  /** Changes of inputs of interventions in addition to those of the cell, in order of time. */
  readonly inputs: readonly InputChange[]
  /** Changes of the override, in order of time. */
  readonly overrides: readonly OverrideChange[]
  /** When the run was ended by hand [s]; null where it came to its own end. */
  readonly stopped: number | null
  /** Names of the parts that have left by a sink, in that order. */
  readonly parts_left: readonly string[]
  /** Of parts; empty for a run that was cut short. */
  readonly destinations: Destinations
  /** Each with its program, in the order of the cell. */
  readonly stations: readonly StationFacts[]
  /** Results of collision checks; null if there was none. */
  readonly ways: WayFacts | null
}
