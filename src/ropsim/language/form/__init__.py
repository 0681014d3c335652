"""The form of a text: the one way in which a program is written, with the same meaning."""

from ropsim.language.form.layout import formatted as formatted
