/** Small pictures of what tasks do, drawn of a few primitives in the colours of the page. */
import type { ReactNode } from 'react'

export function TaskPicture({ name }: { name: string }) {
  return (
    <svg className="task-picture" viewBox="0 0 48 36" aria-hidden="true" focusable="false">
      {PICTURES[name] ?? ANY}
    </svg>
  )
}

interface At {
  readonly x: number
  readonly y: number
}

const Ground = () => <path className="ink" d="M2 33.5 H46" />

const Part = ({ x, y, faint }: At & { faint?: string }) => (
  <rect className={faint ? 'part faint' : 'part'} x={x - 4} y={y - 7} width="8" height="7" rx="1" />
)

/** A gripper whose fingers end at (x, y); `half` is half of their distance. */
const Gripper = ({ x, y, half }: At & { half: number }) => (
  <path
    className="ink"
    d={`M${x} ${y - 17} V${y - 12} M${x - half} ${y} V${y - 10} Q${x - half} ${y - 12} ${x - half + 2} ${y - 12} H${x + half - 2} Q${x + half} ${y - 12} ${x + half} ${y - 10} V${y}`}
  />
)

const Arrow = ({ from, to }: { from: At; to: At }) => {
  const length = Math.hypot(to.x - from.x, to.y - from.y)
  const [ux, uy] = [(to.x - from.x) / length, (to.y - from.y) / length]
  const back = (side: number) => `${to.x - 4 * ux - 2.6 * side * uy} ${to.y - 4 * uy + 2.6 * side * ux}`
  return (
    <path
      className="way"
      d={`M${from.x} ${from.y} L${to.x} ${to.y} M${back(1)} L${to.x} ${to.y} L${back(-1)}`}
    />
  )
}

const Grid = ({ faint }: { faint?: string }) => (
  <>
    {[0, 1, 2].flatMap(column =>
      [0, 1].map(row => (
        <rect
          key={`${column} ${row}`}
          className={faint && column + row > 1 ? 'part faint' : 'part'}
          x={24 + 7.5 * column}
          y={18 + 7.5 * row}
          width="6"
          height="6"
          rx="1"
        />
      )),
    )}
  </>
)

const ANY = (
  <>
    <Ground />
    <circle className="part" cx="24" cy="20" r="7" />
    <path className="ink" d="M24 8 V11 M24 29 V32 M12 20 H15 M33 20 H36" />
  </>
)

const EMPTIED = (
  <>
    <Ground />
    <Grid />
    <Part x={8} y={33} />
    <Arrow from={{ x: 24, y: 12 }} to={{ x: 10, y: 20 }} />
  </>
)

const FILLED = (
  <>
    <Ground />
    <Grid faint="yes" />
    <Part x={8} y={33} />
    <Arrow from={{ x: 10, y: 22 }} to={{ x: 24, y: 12 }} />
  </>
)

const PICTURES: Readonly<Record<string, ReactNode>> = {
  grip: (
    <>
      <Ground />
      <Part x={24} y={33} />
      <Gripper x={24} y={31} half={6} />
      <Arrow from={{ x: 11, y: 24 }} to={{ x: 16, y: 28 }} />
      <Arrow from={{ x: 37, y: 24 }} to={{ x: 32, y: 28 }} />
    </>
  ),
  release: (
    <>
      <Ground />
      <Part x={24} y={33} />
      <Gripper x={24} y={27} half={8} />
      <Arrow from={{ x: 14, y: 28 }} to={{ x: 8, y: 24 }} />
      <Arrow from={{ x: 34, y: 28 }} to={{ x: 40, y: 24 }} />
    </>
  ),
  pick: (
    <>
      <Ground />
      <Part x={18} y={22} />
      <Gripper x={18} y={20} half={6} />
      <Part x={18} y={33} faint="yes" />
      <Arrow from={{ x: 34, y: 31 }} to={{ x: 34, y: 10 }} />
    </>
  ),
  place: (
    <>
      <Ground />
      <Part x={18} y={33} />
      <Gripper x={18} y={22} half={7} />
      <Arrow from={{ x: 34, y: 10 }} to={{ x: 34, y: 31 }} />
    </>
  ),
  insert: (
    <>
      <path className="ink" d="M2 25 H15 V33.5 H33 V25 H46" />
      <Part x={24} y={27} />
      <Gripper x={24} y={23} half={6} />
      <Arrow from={{ x: 38, y: 8 }} to={{ x: 38, y: 21 }} />
    </>
  ),
  move_over: (
    <>
      <Ground />
      <Gripper x={34} y={21} half={6} />
      <Arrow from={{ x: 6, y: 12 }} to={{ x: 24, y: 12 }} />
      <path className="way dashed" d="M34 23 V32" />
    </>
  ),
  park: (
    <>
      <Ground />
      <rect className="ink" x="27" y="4" width="18" height="27" rx="2" />
      <Gripper x={36} y={26} half={6} />
      <Arrow from={{ x: 5, y: 17 }} to={{ x: 22, y: 17 }} />
    </>
  ),
  palletize: EMPTIED,
  unload_pallet: EMPTIED,
  depalletize: FILLED,
  load_pallet: FILLED,
  screw: (
    <>
      <Ground />
      <Part x={24} y={33} />
      <path
        className="ink"
        d="M24 3 V12 M20 12 H28 L26 17 H22 Z M24 17 V26 M21 20 L27 21.5 M21 23 L27 24.5"
      />
      <path className="way" d="M34 14 A11 5 0 1 1 14 14 M34 14 l1.5 -4 M34 14 l-4 -1" />
    </>
  ),
  dispense: (
    <>
      <Ground />
      <path className="ink" d="M28 3 H38 V12 L34 20 H32 L28 12 Z" />
      <path className="bead" d="M6 31 H33" />
      <Arrow from={{ x: 8, y: 22 }} to={{ x: 24, y: 22 }} />
    </>
  ),
  inspect: (
    <>
      <Ground />
      <Part x={24} y={33} />
      <rect className="ink" x="17" y="4" width="14" height="9" rx="2" />
      <circle className="ink" cx="24" cy="8.5" r="2.5" />
      <path className="way dashed" d="M20 15 L14 31 M28 15 L34 31" />
    </>
  ),
  tool_change: (
    <>
      <Ground />
      <Gripper x={12} y={26} half={6} />
      <path className="ink" d="M38 9 V14 M34 14 H42 V20 L38 27 L34 20 Z" />
      <Arrow from={{ x: 19, y: 12 }} to={{ x: 31, y: 12 }} />
    </>
  ),
  load_machine: (
    <>
      <Ground />
      <path className="ink" d="M26 33 V6 H45 V33 M31 12 H45" />
      <circle className="ink" cx="38" cy="22" r="5.5" />
      <Part x={10} y={26} />
      <Arrow from={{ x: 16, y: 22 }} to={{ x: 30, y: 22 }} />
    </>
  ),
  unload_machine: (
    <>
      <Ground />
      <path className="ink" d="M26 33 V6 H45 V33 M31 12 H45" />
      <circle className="ink" cx="38" cy="22" r="5.5" />
      <Part x={9} y={26} />
      <Arrow from={{ x: 30, y: 22 }} to={{ x: 16, y: 22 }} />
    </>
  ),
}
