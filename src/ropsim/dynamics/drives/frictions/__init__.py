"""Laws of friction of drives, a file each."""
