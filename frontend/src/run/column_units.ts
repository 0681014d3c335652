/** Units of the columns of a channel: some axes of an arm turn, others slide. */

interface Axis {
  readonly name: string
  readonly type: 'revolute' | 'prismatic'
}

interface Described {
  readonly unit: string
  readonly columns: readonly string[]
  readonly units?: readonly string[] | undefined
}

/** Of each column of a channel in `rad | m/s` and its like; undefined where all have one unit. */
export function unitsByAxes(
  { unit, columns }: Described,
  axes: readonly Axis[],
): readonly string[] | undefined {
  const [, turning = '', sliding = '', per = ''] = /^(\S+) \| ([^\s/]+)(\/\S+)?$/.exec(unit) ?? []
  if (!turning) return undefined
  const types = new Map(axes.map(({ name, type }) => [name, type]))
  return columns.map(name => {
    const type = types.get(name)
    return type ? (type === 'prismatic' ? sliding : turning) + per : unit
  })
}

/** The unit of a column. */
export function unitOf(channel: Described, column: number): string {
  return channel.units?.[column] ?? channel.unit
}
