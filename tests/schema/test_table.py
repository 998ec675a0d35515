"""Lines of CSV: what is in them comes back."""

import csv
import io

import pytest

from dcfp.schema.table import csv_text


def read_again(values: list[object]) -> list[str]:
    return list(csv.reader(io.StringIO(csv_text(["one"] * len(values), [values]))))[1]


@pytest.mark.parametrize("value", [123.456789, 1.23456789e-7, -98765432.1, 0.1, 1e30])
def test_a_number_keeps_nine_digits(value: float) -> None:
    assert float(read_again([value])[0]) == pytest.approx(value, rel=1e-12)


def test_what_is_no_number_keeps_its_words() -> None:
    row = read_again([None, True, False, 12, 'a, "b"', ["one.", "two."], ["one", "two"]])
    assert row == ["", "true", "false", "12", 'a, "b"', "one. two.", "one; two"]
