"""The control statements of a text, part by part."""
