/** What a run came to, seen at once: verdict, what it left open, and the worst figure of each kind. */
import { resultWords as words } from '../text/result'
import { useStudio, useStudioState } from './context'
import { useUnits } from './hooks'
import { type Tile, tilesOf } from './result_tiles'
import { runMark } from './run_mark'

export function ResultStrip() {
  const studio = useStudio()
  const shown = useStudioState(state => state.shown)
  useStudioState(state => state.looked)
  // The run of the moment may be replaced without any of its words changing: `shown` says so.
  const mark = useStudioState(state => runMark(state, studio.run?.stations ?? []))
  const live = useStudioState(state => state.live !== null && state.live.state !== 'over')
  useUnits()
  const run = shown > 0 ? studio.run : null
  const result = run?.result
  return (
    <section className={mark ? 'result stale' : 'result'} aria-label={words.strip}>
      {run && result ? (
        <>
          <div
            className={`verdict ${result.verdict.kind}`}
            title={`${mark ? `${mark} – ` : ''}${result.verdict.text}\n${result.unchecked}`}
          >
            <strong>
              <span role="img" aria-label={words.spoken[result.verdict.kind]}>
                {words.signs[result.verdict.kind]}
              </span>{' '}
              {mark ? <em>{mark} – </em> : null}
              {result.verdict.text}
            </strong>
            <span className="unchecked">{result.unchecked}</span>
          </div>
          <div className="tiles">
            {tilesOf(run, result).map(tile => (
              <TileButton key={tile.id} tile={tile} />
            ))}
          </div>
        </>
      ) : (
        <div className="verdict">
          <strong>{live || run?.live ? words.live : words.none}</strong>
          <span className="unchecked">{live || run?.live ? words.liveLong : ''}</span>
        </div>
      )}
    </section>
  )
}

function TileButton({ tile }: { tile: Tile }) {
  const studio = useStudio()
  const { id, label, value, detail, tone, time, source, line } = tile
  const act = () => {
    if (id === 'findings') studio.dock?.show('problems')
    if (time !== null) studio.goToMoment(source, line, time)
    else studio.goToRun(source, line)
  }
  return (
    <button
      type="button"
      className={`tile ${tone}`}
      aria-label={words.go(label, value, detail)}
      title={words.go(label, value, detail)}
      disabled={time === null && line === 0 && id !== 'findings'}
      onClick={act}
    >
      <span className="label">{label}</span>
      <span className="value">{value}</span>
      <span className="detail">{detail}</span>
    </button>
  )
}
