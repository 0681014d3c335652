/** Contours of the run: each with its errors, and drawn with the error enlarged; a click goes to the worst. */
import type { Contour } from '../run/run'
import { useStudio, useStudioState } from '../studio/context'
import { words } from '../text/messages'
import { shownUnit } from '../units/quantity'
import { contourPicture, HEIGHT, WIDTH } from './contour_picture'
import { Scroll } from './Scroll'

export function ContoursPanel() {
  const studio = useStudio()
  const shown = useStudioState(state => state.shown)
  const run = shown > 0 ? studio.run : null
  const contours = run?.contours ?? []
  if (contours.length === 0) return <p className="empty">{run ? words.contours.none : words.run.none}</p>
  const several = (run?.stations.length ?? 0) > 1
  return (
    <Scroll label={words.contours.region} className="contours">
      <p className="quiet contour-keys">
        <i className="wanted" /> {words.contours.wanted} <i className="attained" /> {words.contours.attained}
      </p>
      <ul>
        {contours.map(one => (
          <li key={`${one.station} ${one.start}`}>
            <ContourCard contour={one} title={several ? `${one.station}: ${one.name}` : one.name} />
          </li>
        ))}
      </ul>
    </Scroll>
  )
}

function ContourCard({ contour, title }: { contour: Contour; title: string }) {
  const studio = useStudio()
  const picture = contourPicture(contour)
  const { figures } = words.contours
  const rows: readonly (readonly [string, number | null])[] = [
    [figures.path, contour.path_max],
    [figures.mean, contour.path_mean],
    [figures.tracking, contour.tracking_max],
    [figures.end, contour.tracking_end],
    [figures.overshoot, contour.overshoot],
  ]
  return (
    <figure>
      <button
        type="button"
        aria-label={words.contours.go(title)}
        onClick={() => studio.transport.go(contour.time)}
      >
        <svg viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
          <polyline className="wanted" points={picture.wanted} />
          <polyline className="attained" points={picture.attained} />
        </svg>
      </button>
      <figcaption>
        <strong>{title}</strong>
        <span className="quiet">
          {` ${contour.axes[0]}–${contour.axes[1]}, ${words.contours.enlarged(contour.factor)}`}
        </span>
        <dl>
          {rows.map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{error(value)}</dd>
            </div>
          ))}
        </dl>
      </figcaption>
    </figure>
  )
}

/** An error with two digits more than other lengths. */
function error(value: number | null): string {
  if (value === null || !Number.isFinite(value)) return '–'
  const { unit, factor, digits } = shownUnit('m')
  return `${(value * factor).toFixed(digits + 2)} ${unit}`
}
