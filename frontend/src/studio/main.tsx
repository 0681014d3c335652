/** The page of `ropsim studio`. */
import { createRoot } from 'react-dom/client'
import { hasNewKey, takeKey } from '../wire/entry'
import { StudioContext } from './context'
import { installHook } from './hook'
import { keptWrap, restoreSettings } from './page_settings'
import { Shell } from './Shell'
import { Studio } from './studio'
import 'dockview-react/dist/styles/dockview.css'
import '../style/theme.css'
import '../style/shell.css'
import '../style/header.css'
import '../style/result.css'
import '../style/banners.css'
import '../style/footer.css'
import '../style/palette.css'
import '../style/dialog.css'
import '../style/dock.css'
import '../style/panels.css'
import '../style/views.css'
import '../style/states.css'
import '../style/contours.css'
import '../style/plots.css'
import '../style/jog.css'
import '../style/signals.css'
import '../style/cell.css'
import '../style/forced.css'

takeKey()
// An address with a new key, put into this tab, changes its fragment only.
addEventListener('hashchange', () => {
  if (hasNewKey()) location.reload()
})
restoreSettings()
const scheme = location.protocol === 'https:' ? 'wss' : 'ws'
const studio = new Studio(`${scheme}://${location.host}/ws/studio`)
studio.store.setState({ wrap: keptWrap() })
installHook(studio)

const root = document.getElementById('root')
if (root) {
  createRoot(root).render(
    <StudioContext value={studio}>
      <Shell />
    </StudioContext>,
  )
}
studio.start()
