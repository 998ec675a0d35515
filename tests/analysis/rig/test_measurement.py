"""Measured tests from CSV files: units, heads, and one sentence for whatever is wrong with them."""

import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dcfp.analysis.rig import Measurement, read_measurement
from dcfp.errors import InputError

HEAD = "time [s],displacement [mm],force [kN],load [kN],temperature [degC]"
SAMPLES = 201


def columns() -> np.ndarray:
    """Two cycles of a Coulomb loop in s, mm, kN, kN and degC."""
    time = 0.02 * np.arange(SAMPLES)
    displacement = 200.0 * np.sin(math.pi * time)
    force = 0.84 * displacement + 324.0 * np.sign(np.cos(math.pi * time))
    load = 7540.0 + 50.0 * np.sin(5.0 * time)
    return np.column_stack((time, displacement, force, load, 20.0 + 10.0 * time))


def text(head: str = HEAD, values: np.ndarray | None = None, separator: str = ",") -> str:
    rows = columns() if values is None else values
    return "\n".join([head, *(separator.join(f"{value:.6g}" for value in row) for row in rows)]) + "\n"


LINES = text().splitlines()


@pytest.fixture
def read(tmp_path: Path) -> Callable[[str | bytes], Measurement]:
    def write_and_read(content: str | bytes) -> Measurement:
        path = tmp_path / "measured.csv"
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return read_measurement(path)

    return write_and_read


def assert_same(measurement: Measurement) -> None:
    time, displacement, force, load, temperature = columns().T
    assert measurement.time == pytest.approx(time, rel=1e-5, abs=1e-9)
    assert measurement.displacement == pytest.approx(displacement, rel=1e-5, abs=1e-3)
    assert measurement.force == pytest.approx(1e3 * force, rel=1e-5, abs=1.0)
    assert measurement.load == pytest.approx(1e3 * load, rel=1e-5)
    assert measurement.optional_temperature == pytest.approx(temperature, rel=1e-5)


# ----- what is read -----


def test_a_file_is_read_in_newtons_millimetres_and_seconds(read) -> None:
    measurement = read(text())
    assert_same(measurement)
    assert measurement.name == "measured"
    assert len(measurement.digest) == 64
    assert len(measurement.cycles) == 2
    assert measurement.cycles[1].friction == pytest.approx(324.0 / 7540.0, rel=0.01)


@pytest.mark.parametrize(
    ("column", "unit", "factor"),
    [
        (0, "s", 1.0), (0, "ms", 1e3),
        (1, "mm", 1.0), (1, "cm", 0.1), (1, "m", 1e-3), (1, "in", 1.0 / 25.4),
        (2, "N", 1e3), (2, "kN", 1.0), (2, "MN", 1e-3), (2, "kip", 1.0 / 4.4482216152605),
        (3, "N", 1e3), (3, "kN", 1.0), (3, "MN", 1e-3), (3, "kip", 1.0 / 4.4482216152605),
        (4, "degC", 1.0), (4, "°C", 1.0), (4, "C", 1.0),
    ],
)  # fmt: skip
def test_every_unit_is_converted(read, column: int, unit: str, factor: float) -> None:
    names = ["time", "displacement", "force", "load", "temperature"]
    units = ["s", "mm", "kN", "kN", "degC"]
    units[column] = unit
    values = columns()
    values[:, column] *= factor
    rows = "\n".join(",".join(repr(float(value)) for value in row) for row in values)
    assert_same(read(",".join(f"{n} [{u}]" for n, u in zip(names, units, strict=True)) + "\n" + rows))


@pytest.mark.parametrize(
    "head",
    [
        "time (s),displacement (mm),force (kN),load (kN),temperature (degC)",
        " Time[s] , Displacement [ mm ],FORCE [kN],Load  [kN],temperature [C]",
        '"time [s]","displacement [mm]","force [kN]","load [kN]","temperature [degC]"',
    ],
)
def test_heads_are_written_in_many_ways(read, head: str) -> None:
    assert_same(read(text(head)))


def test_the_order_of_columns_and_others_beside_them_do_not_matter(read) -> None:
    values = np.column_stack((columns()[:, ::-1], np.arange(SAMPLES)))
    head = "temperature [degC],load [kN],force [kN],displacement [mm],time [s],channel 7"
    assert_same(read(text(head, values)))


def test_notes_empty_lines_and_the_ends_of_lines_do_not_matter(read) -> None:
    rows = ["# tested in the year 2020, by hand", *LINES[:50], "", "  ", "# a note, in between", *LINES[50:]]
    assert_same(read("\n".join(rows)))
    assert_same(read("\r\n".join(rows)))
    assert_same(read(b"\xef\xbb\xbf" + text().encode()))


def test_time_begins_at_zero(read) -> None:
    values = columns()
    values[:, 0] += 1000.0
    head = "\n".join([HEAD, *(",".join(f"{value:.9g}" for value in row) for row in values)])
    assert_same(read(head))


def test_force_and_load_may_be_missing_until_they_are_needed(read) -> None:
    measurement = read(text("time [s],displacement [mm]", columns()[:, :2]))
    assert measurement.cycle_times == pytest.approx([0.0, 2.0, 4.0], abs=1e-6)
    for quantity in ("force", "load", "cycles"):
        with pytest.raises(
            InputError, match=r"measured: the file has no column '(force|load) .kN.', which is needed here"
        ):
            getattr(measurement, quantity)


# ----- what is refused -----


def replaced(line: int, row: str) -> str:
    """Return the file with another row in a line, counted from one."""
    return "\n".join([*LINES[: line - 1], row, *LINES[line:]])


def scaled(column: int, factor: float) -> str:
    values = columns()
    values[:, column] *= factor
    return text(values=values)


WRONG = {
    "no head": ("\n".join(LINES[1:]), "names no column 'time \\[s\\]'"),
    "no displacement": (text("time [s],way [mm],force [kN],load [kN],temperature [C]"), "no column 'displacement \\[mm\\]'"),
    "no unit": (text(HEAD.replace(" [mm]", "")), "column 'displacement' has no unit; write it in brackets"),
    "empty unit": (text(HEAD.replace("[mm]", "[]")), "unit '' of the column 'displacement' is not known"),
    "unknown unit": (text(HEAD.replace("[mm]", "[furlong]")), "unit 'furlong' .* choices are mm, cm, m, in"),
    "wrong unit": (text(HEAD.replace("[mm]", "[kN]")), "unit 'kN' of the column 'displacement' is not known"),
    "double column": (text(HEAD.replace("temperature [degC]", "load [kN]")), "two columns 'load'"),
    "bars": (text(HEAD.replace(",", "|"), separator="|"), "first line"),
    "empty": ("", "the file is empty"),
    "only notes": ("# nothing\n\n# more\n", "the file is empty"),
    "only a head": (HEAD + "\n", "there are 0 samples; at least 20"),
    "few samples": ("\n".join(LINES[:20]), "there are 19 samples; at least 20"),
    "time twice": (replaced(52, LINES[50]), "line 52: time goes from 0.98 to 0.98 s after the start"),
    "time back": (replaced(52, LINES[40]), "line 52: time goes from 0.98 to 0.78 s"),
    "gap": ("\n".join([*LINES[:50], *LINES[70:]]), "line 51: a gap of 0.42 s where samples are 0.02 s apart"),
    "number missing": (replaced(52, "1,,0,7540,20"), "line 52: the displacement is missing"),
    "row cut short": (replaced(52, "1,0,0"), "line 52: the load is missing"),
    "a word": (replaced(52, "1,nought,0,7540,20"), "line 52: the displacement is 'nought', not a number"),
    "not a number": (replaced(52, "1,nan,0,7540,20"), "line 52: the displacement is 'nan', not a number"),
    "infinity": (replaced(52, "1,0,-inf,7540,20"), "line 52: the force is '-inf', not a number"),
    "decimal comma": (replaced(52, '1,"0,5",0,7540,20'), "line 52: the displacement is '0,5', not a number"),
    "tension": (replaced(52, "1,0,-324,-10,20"), "line 52: the load is -10 kN; a sliding bearing takes no tension"),
    "load upside down": (scaled(3, -1.0), "line 2: the load is -7540 kN"),
    "displacement in m": (scaled(1, 1e-3), "largest displacement is 0.2 mm"),
    "displacement in um": (scaled(1, 1e3), "largest displacement is 2e\\+05 mm"),
    "time in ms": (scaled(0, 1e-3), "largest velocity is .* look at the units of time and displacement"),
    "force in N": (scaled(2, 1e3), "largest force is .* times the load; look at the units of both"),
    "force in MN": (scaled(2, 1e-3), "largest force is .* times the load"),
    "load in N": (scaled(3, 1e3), "largest force is .* times the load"),
    "load in MN": (scaled(3, 1e-3), "largest force is .* times the load"),
    "binary": (bytes(range(128, 256)) * 10, "this is not a text file"),
    "UTF-16": (text().encode("utf-16"), "this is not a text file"),
}  # fmt: skip


def assert_one_sentence(message: str) -> None:
    assert "\n" not in message
    assert message.endswith((".", ".)"))
    assert len(message) < 400


@pytest.mark.parametrize("what", WRONG)
def test_what_is_wrong_is_said_in_one_sentence_with_the_file_and_the_line(read, what: str) -> None:
    content, sentence = WRONG[what]
    with pytest.raises(InputError, match=sentence) as caught:
        read(content)
    assert "measured.csv" in str(caught.value)
    assert_one_sentence(str(caught.value))


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"none\.csv: there is no such file") as caught:
        read_measurement(tmp_path / "none.csv")
    assert_one_sentence(str(caught.value))


def test_a_folder_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="this is a folder") as caught:
        read_measurement(tmp_path)
    assert_one_sentence(str(caught.value))


# ----- damage -----


@st.composite
def damaged(draw: st.DrawFn) -> bytes:
    """A good file after up to four accidents."""
    content = bytearray(text().encode())
    for _ in range(draw(st.integers(1, 4))):
        kind = draw(st.sampled_from(("cut", "bytes", "delete", "double", "swap", "insert", "field")))
        rows = bytes(content).split(b"\n")
        one, other = (draw(st.integers(0, len(rows) - 1)) for _ in range(2))
        if kind == "cut":
            content = content[: draw(st.integers(0, len(content)))]
        elif kind == "bytes" and content:
            for place in draw(st.lists(st.integers(0, len(content) - 1), max_size=8)):
                content[place] = draw(st.integers(0, 255))
        elif kind == "insert":
            place = draw(st.integers(0, len(content)))
            content[place:place] = draw(
                st.one_of(
                    st.binary(max_size=20), st.sampled_from((b'"', b",", b"\x00", b"\r", b"1e999", b"-"))
                )
            )
        elif kind == "field":
            fields = rows[one].split(b",")
            fields[draw(st.integers(0, len(fields) - 1))] = draw(
                st.sampled_from(
                    (b"", b"nan", b"1e308", b"-1e308", b"1_0", b"0x10", b"1e-320", b"\xd9\xa1", b"0")
                )
            )
            rows[one] = b",".join(fields)
            content = bytearray(b"\n".join(rows))
        else:
            if kind == "delete":
                del rows[one]
            elif kind == "double":
                rows.insert(other, rows[one])
            else:
                rows[one], rows[other] = rows[other], rows[one]
            content = bytearray(b"\n".join(rows))
    return bytes(content)


@pytest.mark.slow
@settings(
    max_examples=300, deadline=None, derandomize=True,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)  # fmt: skip
@given(damaged())
def test_damage_is_told_or_harmless(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "damaged.csv"
    path.write_bytes(content)
    message = ""
    try:
        measurement = read_measurement(path)
    except InputError as error:
        message = str(error)
    if message:
        assert "damaged.csv" in message
        assert_one_sentence(message)
        return
    assert np.isfinite(measurement.time).all()
    assert np.isfinite(measurement.displacement).all()
    assert (np.diff(measurement.time) > 0.0).all()
    assert measurement.time[0] == 0.0
