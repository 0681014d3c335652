"""A figure of the HTML report: caption, legend, picture."""

from ropsim.views.markup import text

_KEYS = {
    "limit": '<span class="key"><i class="limit"></i>limit</span>',
    "attained": '<span class="key"><i></i>attained</span>',
    "command": '<span class="key"><i class="c2"></i>command</span>',
    "band": '<span class="key"><i class="band"></i>tool path</span>',
    "way": '<span class="key"><i></i>attained path</span>',
    "straight": '<span class="key"><i class="c2"></i>tool path</span>',
    "grip": '<span class="key"><i class="dot"></i>grip</span>',
    "release": '<span class="key"><i class="square"></i>release</span>',
    "peak": '<span class="key">right: largest value</span>',
}


def figure(title: str, keys: tuple[str, ...], body: str) -> str:
    """Return a picture with its title and the keys of its legend, in that order."""
    legend = "".join(_KEYS[key] for key in keys)
    caption = f"<figcaption><strong>{text(title)}</strong>{legend}</figcaption>"
    return f'<figure>{caption}\n<div class="scroll" tabindex="0">{body}</div></figure>\n'
