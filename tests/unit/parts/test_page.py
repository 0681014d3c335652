"""The page of parts shows the catalogue as it is."""

from tools import part_page


def test_page_and_pictures_are_those_of_the_catalogue() -> None:
    assert part_page.main(["--check"]) == 0
