"""Spectra from files: every way of writing one, and one sentence for every fault."""

import pytest

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.methods.spectra.elastic import read_spectrum

GOOD = {
    "commas": "period [s], acceleration [g]\n0.5, 1.0\n1.0, 0.5\n",
    "semicolons and decimal commas": "T [s];Sa [g]\n0,5;1,0\n1,0;0,5\n",
    "tabs": "Period (s)\tPSA (g)\n0.5\t1.0\n1.0\t0.5\n",
    "blanks": "period [s]   acceleration [g]\n  0.5   1.0\n  1.0   0.5\n",
    "comments and a byte order mark": "\ufeff# made by hand\n\nperiod [s],S_a [g]\n! a remark\n0.5,1.0 # corner\n\n1.0,0.5\n",
    "other order and another column": "acceleration [g],velocity [m/s],period [s]\n1.0,0.3,0.5\n0.5,,1.0\n",
    "damping in the name": "T [s], Sa (5 %) [g]\n0.5, 1.0\n1.0, 0.5\n",
    "quotes and Windows": '"period [s]","acceleration [g]"\r\n0.5,1.0\r\n1.0,0.5,\r\n',
    "exponents": "period [s],acceleration [g]\n5.0E-1,1.0D0\n1e0,+5e-1\n",
}


@pytest.fixture
def write(tmp_path):
    def to_file(content, name="site.csv"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return to_file


@pytest.mark.parametrize("content", GOOD.values(), ids=GOOD.keys())
def test_every_way_of_writing(write, content):
    spectrum = read_spectrum(write(content))
    assert spectrum.name == "site"
    assert spectrum.periods == pytest.approx([0.5, 1.0])
    assert spectrum.accelerations == pytest.approx([STANDARD_GRAVITY, 0.5 * STANDARD_GRAVITY])


@pytest.mark.parametrize(
    ("unit", "size"), [("g", STANDARD_GRAVITY), ("m/s2", 1e3), ("m/s^2", 1e3), ("gal", 10.0), ("mm/s²", 1.0)]
)
def test_units(write, unit, size):
    spectrum = read_spectrum(write(f"period [s],acceleration [{unit}]\n0.5,2\n1,1\n"), name="mine")
    assert spectrum.accelerations == pytest.approx([2.0 * size, size])
    assert spectrum.name == "mine"


BAD = {
    "empty": ("# nothing\n", "empty"),
    "no header": ("0.5,1.0\n1.0,0.5\n", "no column of period"),
    "no acceleration": ("period [s],velocity [m/s]\n0.5,1.0\n1.0,0.5\n", "no column of acceleration"),
    "no unit": ("period [s],acceleration\n0.5,1.0\n1.0,0.5\n", "'acceleration' has no unit"),
    "unknown unit": ("period [s],acceleration [ft/s2]\n0.5,1.0\n1.0,0.5\n", "'ft/s2'; use one of g"),
    "milliseconds": ("period [ms],acceleration [g]\n500,1.0\n1000,0.5\n", "must be in s"),
    "two accelerations": ("period [s],Sa [g],PSA [g]\n0.5,1,1\n1,1,1\n", "two columns of acceleration"),
    "one row": ("period [s],acceleration [g]\n0.5,1.0\n", "at least two rows"),
    "a value too few": ("period [s],acceleration [g]\n0.5,1.0\n1.0\n", "line 3: 1 values stand"),
    "a value too many": ("period [s],acceleration [g]\n0.5,1.0,2.0\n1.0,1.0\n", "line 2: 3 values stand"),
    "no number": ("period [s],acceleration [g]\n0.5,one\n1.0,0.5\n", "line 2: the acceleration is 'one'"),
    "not finite": ("period [s],acceleration [g]\n0.5,nan\n1.0,0.5\n", "line 2: the acceleration is 'nan'"),
    "not increasing": (
        "period [s],acceleration [g]\n0.5,1.0\n0.5,0.5\n",
        "line 3: the period of 0.5 s follows",
    ),
    "zero acceleration": (
        "period [s],acceleration [g]\n0.5,1.0\n1.0,0.0\n",
        "line 3: the acceleration is 0,",
    ),
    "period zero": ("period [s],acceleration [g]\n0,1.0\n1.0,0.5\n", "leave out the row"),
    "not text": (b"\xff\xfe\x00\x01", "a binary file"),
}


@pytest.mark.parametrize(("content", "sentence"), BAD.values(), ids=BAD.keys())
def test_one_sentence_for_every_fault(write, content, sentence):
    with pytest.raises(InputError) as caught:
        read_spectrum(write(content))
    text = str(caught.value)
    assert sentence in text
    assert "site.csv" in text
    assert text.endswith(".")
    assert "\n" not in text


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(InputError, match="no such file; a spectrum with a header"):
        read_spectrum(tmp_path / "absent.csv")
    with pytest.raises(InputError, match="this is a folder"):
        read_spectrum(tmp_path)
