/** The picture in words, for people who do not see it. */
import type { Run } from '../run/run'
import { channelOf } from '../run/station'
import type { Pose, SceneDescription, StationDescription } from '../scene/description'
import { words } from '../text/messages'
import { jointName } from '../units/names'
import { compose } from '../units/pose'
import { formatNumber, shownUnit } from '../units/quantity'

/** Pose of the TCP of a station in W at the shown poses; null where the cell marks none. */
function tcpOf(scene: SceneDescription, station: string, poses: Float32Array): Pose | null {
  const mark = scene.frames.find(frame => frame.kind === 'tcp' && frame.name === channelOf('tcp', station))
  if (!mark || poses.length < 7 * (mark.parent + 1)) return null
  if (mark.parent < 0) return mark.pose
  const at = (k: number) => poses[7 * mark.parent + k] ?? 0
  return compose([at(0), at(1), at(2), at(3), at(4), at(5), at(6)], mark.pose)
}

/** Share of the way from the middle of its range to its limit that a joint has gone: 1 at the limit. */
export function limitShare(value: number, lower: number, upper: number): number {
  const half = (upper - lower) / 2
  return half > 0 && Number.isFinite(half) ? Math.abs(value - (upper + lower) / 2) / half : 0
}

/** An arm that is jogged: it stands elsewhere than the run shows it. */
export interface JoggedArm {
  readonly station: string
  /** Joint coordinates [rad | m]. */
  readonly q: readonly number[]
  /** Pose of the TCP in W. */
  readonly tcp: Pose
}

/** "TCP 435.1, 120.0, 612.4 mm; Joint 3: 97 % of the way to its limit" */
export function textTwin(
  scene: SceneDescription,
  poses: Float32Array,
  run: Run | null,
  time: number,
  jogged: JoggedArm | null = null,
): string {
  const texts = scene.stations.map(station => {
    const own = jogged?.station === station.name ? jogged : null
    const text = stationTwin(scene, station, poses, run, time, own)
    return scene.stations.length > 1 && text ? words.twin.station(station.name, text) : text
  })
  return texts.filter(Boolean).join('. ')
}

function stationTwin(
  scene: SceneDescription,
  { name, joints }: StationDescription,
  poses: Float32Array,
  run: Run | null,
  time: number,
  jogged: JoggedArm | null,
): string {
  const parts: string[] = []
  const tcp = jogged ? jogged.tcp : tcpOf(scene, name, poses)
  if (tcp)
    parts.push(
      words.twin.tcp(
        [0, 1, 2].map(k => formatNumber(tcp[k] ?? Number.NaN, 'm')),
        shownUnit('m').unit,
      ),
    )
  let worst = { name: '', share: 0 }
  joints.forEach((joint, at) => {
    const share = limitShare(
      (jogged ? jogged.q[at] : run?.value(channelOf('q', name), at, time)) ?? Number.NaN,
      joint.lower,
      joint.upper,
    )
    if (share > worst.share) worst = { name: jointName(joint.name), share }
  })
  if (worst.name) parts.push(words.twin.joint(worst.name, Math.round(100 * worst.share)))
  return parts.join('; ')
}
