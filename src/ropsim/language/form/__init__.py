"""The form of a text: the one way in which a program is written, without a change of what it means."""

from ropsim.language.form.layout import formatted as formatted
