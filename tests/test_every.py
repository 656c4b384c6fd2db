"""One test of a whole table: it fails by every row that fails, and by a table without rows."""

import pytest

from every import every


def test_all_rows_that_fail_are_reported() -> None:
    @every([3, 0, -2, 5])
    def test_a_share_of_ten_is_positive(row: int) -> None:
        """What a row is to hold."""
        assert 10 / row > 0, "negative"

    with pytest.raises(AssertionError) as caught:
        test_a_share_of_ten_is_positive()
    first, zero, negative, *_ = str(caught.value).splitlines()
    assert first == "2 of 4 rows fail"
    assert zero.startswith("0: ZeroDivisionError")
    assert negative.startswith("-2: AssertionError negative")
    assert "5: " not in str(caught.value)
    assert test_a_share_of_ten_is_positive.__doc__ == "What a row is to hold."


def test_a_tuple_is_several_arguments_and_rows_are_named() -> None:
    @every([(1, 2), (2, 1)], name=lambda row: f"row of {row[0]}")
    def test_first_is_less(first: int, second: int) -> None:
        assert first < second

    with pytest.raises(AssertionError, match=r"1 of 2 rows fail\nrow of 2: "):
        test_first_is_less()


def test_rows_that_hold_pass() -> None:
    @every("abc")
    def test_is_a_letter(letter: str) -> None:
        assert letter.isalpha()

    test_is_a_letter()


def test_a_table_without_rows_fails() -> None:
    @every([])
    def test_of_nothing(row: object) -> None:
        """Holds of every row."""

    with pytest.raises(AssertionError, match="no rows"):
        test_of_nothing()
