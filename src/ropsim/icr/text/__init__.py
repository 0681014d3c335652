"""The text form: tokens to a program and back."""
