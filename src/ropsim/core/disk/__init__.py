"""Files, locks, folders of the user, and files kept between processes."""
