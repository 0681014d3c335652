/** Findings of the run; those with a time lead there. */
import type { Finding } from '../run/run'
import { element } from './elements'
import { words } from './words'

/** `files`: whether a line is told with its file, as where there are several programs. */
export function findingsList(
  findings: readonly Finding[],
  files: 'named' | 'known',
  go: (time: number, place: Finding['place']) => void,
): HTMLElement {
  if (findings.length === 0) return element('p', { class: 'replay-quiet' }, words.noFindings)
  const list = element('ul', { class: 'replay-findings' })
  for (const finding of findings) list.append(element('li', {}, entry(finding, files, go)))
  return list
}

function entry(
  finding: Finding,
  files: 'named' | 'known',
  go: (time: number, place: Finding['place']) => void,
): HTMLElement {
  const { code, severity, message, hint, span, time } = finding
  const file = span && files === 'named' ? `${span.source.replace(/^.*[\\/]/, '')} ` : ''
  const place = [span ? file + words.line(span.line) : '', time === null ? '' : `${time.toFixed(2)} s`]
  const content = [
    element('strong', { 'data-severity': severity }, `${words.severities[severity]} ${code}`),
    ` ${place.filter(Boolean).join(', ')} `,
    element('span', {}, message),
    ...(hint ? [element('em', {}, ` ${hint}`)] : []),
  ]
  if (time === null) return element('p', {}, ...content)
  const button = element('button', { type: 'button' }, ...content)
  button.addEventListener('click', () => go(time, finding.place))
  return button
}
