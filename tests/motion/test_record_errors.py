"""Whatever happens to a file: a ground motion or an InputError, and nothing else."""

import contextlib
import re

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import read_motion, read_motions

RELAXED = settings(deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
PIECES = (
    b"nan",
    b"inf",
    b"1e999",
    b"1_000",
    b"-",
    b".",
    b"9" * 400,
    b"\xff\xfe",
    b"\x00",
    b"0",
    b"1D5",
    b" ",
    b"x",
)


def truncate(content: bytes, data: st.DataObject) -> bytes:
    return content[: data.draw(st.integers(0, len(content)))]


def replace_bytes(content: bytes, data: st.DataObject) -> bytes:
    damaged = bytearray(content)
    for _ in range(data.draw(st.integers(1, 4))):
        damaged[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    return bytes(damaged)


def replace_word(content: bytes, data: st.DataObject) -> bytes:
    words = list(re.finditer(rb"\S+", content))
    word = words[data.draw(st.integers(0, len(words) - 1))]
    return content[: word.start()] + data.draw(st.sampled_from(PIECES)) + content[word.end() :]


def change_lines(content: bytes, data: st.DataObject) -> bytes:
    lines = content.split(b"\n")
    place = data.draw(st.integers(0, len(lines) - 1))
    count = data.draw(st.integers(1, 5))
    if data.draw(st.booleans()):
        return b"\n".join(lines[:place] + lines[place + count :])
    return b"\n".join(lines[: place + count] + lines[place:])


def concatenate(content: bytes, data: st.DataObject) -> bytes:
    place = data.draw(st.integers(0, len(content)))
    return content + content[place:]


DAMAGES = (truncate, replace_bytes, replace_word, change_lines, concatenate)


def read_safely(path, options):
    with contextlib.suppress(InputError):
        motions = read_motions(path, **options)
        assert motions
        for motion in motions:
            assert isinstance(motion, GroundMotion)
            assert np.isfinite(motion.acceleration).all()
            assert np.isfinite(motion.displacement).all()


@pytest.mark.parametrize("damage", DAMAGES)
@given(data=st.data())
@settings(RELAXED, max_examples=30)
def test_damaged_file(made, written, damage, data):
    read_safely(written(made, damage(made.content, data)), made.options)


@pytest.mark.parametrize("damage", DAMAGES)
@given(data=st.data())
@settings(RELAXED, max_examples=8)
def test_damaged_sample(sample, written, damage, data):
    read_safely(written(sample, damage(sample.read_bytes(), data)), {})


@given(content=st.binary(max_size=300))
@settings(RELAXED, max_examples=200)
def test_any_bytes(content, tmp_path):
    path = tmp_path / "any"
    path.write_bytes(content)
    read_safely(path, {"units": "g", "time_step": 0.01})


@pytest.mark.slow
@given(text=st.text("0123456789.,;+-eEdDnaif \t\n", max_size=200))
@settings(RELAXED, max_examples=300)
def test_any_numbers(text, tmp_path):
    path = tmp_path / "any"
    path.write_text(text)
    read_safely(path, {"units": "g", "time_step": 0.01})
    read_safely(path, {"units": "g"})


def test_every_missing_or_repeated_line_of_values_is_noticed(made, written):
    if not made.counted:
        pytest.skip("the format does not say how many values there are")
    lines = made.content.split(b"\n")
    first = made.first_value_line - 1
    for changed in (
        lines[: first + 2] + lines[first + 3 :],
        lines[: first + 3] + lines[first + 2 :],
        lines[: first + 3],
    ):
        with pytest.raises(InputError):
            read_motions(written(made, b"\n".join(changed)))


def test_truncation_at_any_line_is_noticed(made, written):
    if not made.counted:
        pytest.skip("the format does not say how many values there are")
    lines = made.content.rstrip().split(b"\n")
    ends = {len(lines) - 1} if lines[-1][:2] in {b"/&", b"En"} else set()
    for length in set(range(len(lines))) - ends:
        content = b"\n".join(lines[:length])
        if content.rstrip().endswith(
            (b"channel  1  ----------", b"channel  2  ----------", b"1 acceleration")
        ):
            continue  # a whole channel: nothing says that others were to follow
        try:
            read = read_motions(written(made, content))
        except InputError:
            continue
        # Only the line that ends a channel may be missing, after all of its values.
        assert lines[length].startswith(b"End-of-data")
        assert all(motion.acceleration.size == 43 for motion in read)


@pytest.mark.parametrize("word", ["nan", "NaN", "inf", "1_0", "text", "1e999", "--1"])
def test_text_among_the_values(made, written, word):
    lines = made.content.split(b"\n")
    line = lines[made.first_value_line]
    number = re.search(rb"[-.0-9][-+.0-9Ee]*", line)
    assert number is not None
    damaged = line[: number.start()] + word.encode().rjust(len(number[0])) + line[number.end() :]
    content = b"\n".join([*lines[: made.first_value_line], damaged, *lines[made.first_value_line + 1 :]])
    with pytest.raises(InputError, match=f"line {made.first_value_line + 1}: "):
        read_motions(written(made, content), **made.options)


def test_missing_file(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_motion(tmp_path / "none.AT2")


def test_folder(tmp_path):
    with pytest.raises(InputError, match="folder"):
        read_motion(tmp_path)


@pytest.mark.parametrize("content", [b"", b"  \n\n ", b"\n"])
def test_empty(tmp_path, content):
    (tmp_path / "empty").write_bytes(content)
    with pytest.raises(InputError, match="empty"):
        read_motion(tmp_path / "empty")


def test_binary(tmp_path):
    (tmp_path / "binary").write_bytes(b"\x89HDF\r\n\x1a\n\x00\x00\x00")
    with pytest.raises(InputError, match="binary"):
        read_motion(tmp_path / "binary")


def test_path_with_a_null_character():
    with pytest.raises(InputError, match="cannot be read"):
        read_motion("a\x00b.AT2")


def test_too_large(tmp_path, monkeypatch):
    monkeypatch.setattr("dcfp.motion.formats.source.MAXIMUM_SIZE", 10)
    (tmp_path / "large").write_text("1.0\n" * 10)
    with pytest.raises(InputError, match="larger than"):
        read_motion(tmp_path / "large")


def test_prose(tmp_path):
    (tmp_path / "prose.txt").write_text("It was a dark and stormy night.\n" * 5)
    with pytest.raises(InputError, match="none of the known record formats"):
        read_motion(tmp_path / "prose.txt", units="g")


@pytest.mark.parametrize(
    ("text", "options", "match"),
    [
        ("1\n2\n3\n", {}, "give the unit"),
        ("1\n2\n3\n", {"units": "furlong"}, "unit 'furlong' is not known"),
        ("1\n2\n3\n", {"units": "g"}, "give the time step"),
        ("1\n2\n3\n", {"units": "g", "time_step": 0.0}, "time step"),
        ("1\n2\n3\n", {"units": "g", "time_step": -0.01}, "time step"),
        ("1\n2\n3\n", {"units": "g", "time_step": float("nan")}, "time step"),
        ("1\n", {"units": "g", "time_step": 0.01}, "fewer than two"),
        ("1e8\n1\n", {"units": "g", "time_step": 0.01}, "100 000 g"),
        ("1 2 3\n1 2 3\n", {"units": "g"}, "3 columns"),
        ("0.0 1\n0.1 2\n0.3 3\n", {"units": "g"}, "too few digits"),
        ("0.00 1\n0.10 2\n0.30 3\n", {"units": "g"}, "equally spaced"),
        ("0.0 1\n0.0 2\n0.1 3\n", {"units": "g"}, "must go up"),
        ("0.0 1\n0.1 2\n0.2\n", {"units": "g"}, "line 3: 1 values stand where 2"),
        ("0.0 1\n0.1 2\n\n0.2 3\n", {"units": "g"}, "line 3"),
        ("0.0 1\n0.1 2\n0.2 3\n", {"units": "g", "time_step": 0.2}, "step of 0.1 s"),
        ("0.0,1\n0.1,,2\n", {"units": "g"}, "line 2"),
    ],
)
def test_plain_columns(tmp_path, text, options, match):
    path = tmp_path / "plain.txt"
    path.write_text(text)
    with pytest.raises(InputError, match=match):
        read_motions(path, **options)


@pytest.mark.parametrize(
    ("units", "size"),
    [
        ("mm/s2", 1),
        ("cm/s^2", 10),
        ("GAL", 10),
        ("M/S**2", 1000),
        ("g", 9806.65),
        ("G", 9806.65),
        ("cm/sec/sec", 10),
    ],
)
def test_units(tmp_path, units, size):
    path = tmp_path / "plain.txt"
    path.write_text("0\n1\n2\n")
    np.testing.assert_allclose(
        read_motion(path, units=units, time_step=0.01).acceleration, [0, size, 2 * size]
    )


@pytest.mark.parametrize(
    ("name", "line", "match"),
    [
        ("csmip", b"/&", "2 blocks of acceleration"),
        ("csmip", b"    43 points of accel", "0 blocks of acceleration"),
        ("cosmos", b"     43 acceleration pts", "2 real headers"),
    ],
)
def test_channels_are_not_confused(name, line, match, make_file, written):
    """A channel whose end or announcement is lost must not lend its name to the next one."""
    made = make_file(name)
    lines = made.content.split(b"\n")
    place = next(index for index, text in enumerate(lines) if text.startswith(line))
    with pytest.raises(InputError, match=match):
        read_motions(written(made, b"\n".join(lines[:place] + lines[place + 1 :])))
