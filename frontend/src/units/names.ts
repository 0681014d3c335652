/** What recorded numbers are called: in tables, plots, lists, tooltips and CSV files alike. */

const JOINT_QUANTITIES: Readonly<Record<string, string>> = {
  q: 'position',
  qd: 'speed',
  tau: 'torque',
  current: 'motor current',
  voltage: 'motor voltage',
  pressure_a: 'pressure A',
  pressure_b: 'pressure B',
  opening: 'valve opening',
  opening_rate: 'rate of valve opening',
  valve_current: 'valve current',
  q_ref: 'commanded position',
  qd_ref: 'commanded speed',
  q_error: 'position error',
  power: 'power drawn',
}

const OTHERS: Readonly<Record<string, string>> = {
  attained_position: 'TCP position',
  attained_orientation: 'TCP orientation',
  command_position: 'Commanded TCP position',
  command_orientation: 'Commanded TCP orientation',
  tcp_speed: 'TCP speed',
  path_error: 'Path error',
  gripper: 'Gripper',
  line: 'Program line',
  move: 'Move',
  payload: 'Payload',
  override: 'Override',
}

/** A joint by its name in the model: numbers become `Joint 1`. */
export function jointName(name: string): string {
  return /^\d+$/.test(name) ? `Joint ${name}` : name
}

/** Owner and quantity of a channel: `left` and `q` of `left/q`; no owner where it is named by its quantity alone. */
export function partsOf(channel: string): { readonly owner: string; readonly quantity: string } {
  const at = channel.startsWith('signal.') ? -1 : channel.indexOf('/')
  return { owner: channel.slice(0, Math.max(at, 0)), quantity: channel.slice(at + 1) }
}

function owned(owner: string, text: string): string {
  return owner ? `${owner}: ${text}` : text
}

/** A channel as a whole: `left: Speed`, `TCP position`; one that nobody has named keeps its own name. */
export function channelName(channel: string): string {
  const { owner, quantity } = partsOf(channel)
  return owned(owner, quantityName(quantity))
}

/** The same where the station or device is told already. */
export function quantityName(channel: string): string {
  const quantity = JOINT_QUANTITIES[channel]
  if (quantity) return quantity.charAt(0).toUpperCase() + quantity.slice(1)
  return OTHERS[channel] ?? channel.replace(/^signal\./, '')
}

/** A column where its channel is told already: `Joint 3`, `x`. */
export function columnLabel(channel: string, column: string): string {
  return partsOf(channel).quantity in JOINT_QUANTITIES ? jointName(column) : column
}

/** A column on its own: `Joint 3 speed`, `left: TCP position x`. */
export function columnName(channel: string, column: string): string {
  const { owner, quantity: name } = partsOf(channel)
  const quantity = JOINT_QUANTITIES[name]
  if (quantity && column) return owned(owner, `${jointName(column)} ${quantity}`)
  return [channelName(channel), column].filter(Boolean).join(' ')
}

/** The short name that models and recordings use: `qd 3`. It stands in tooltips. */
export function symbolOf(channel: string, column: string): string {
  return [channel, column].filter(Boolean).join(' ')
}
