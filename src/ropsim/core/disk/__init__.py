"""Files, locks, folders of the user, and what is kept between processes."""
