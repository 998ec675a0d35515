"""The bearing of the paper, others from TOML, and refusals."""

import math

import pytest

from dcfp.errors import InputError
from dcfp.system import (
    LI_2020,
    Bearing,
    Kumar2015,
    Li2020,
    PreciseHeating,
    SimplifiedHeating,
    heating_model,
    read_bearing,
)
from dcfp.system.heating import constant_flux_rise


def test_constants_of_the_paper():
    assert LI_2020.vertical_force == pytest.approx(7.540e6, rel=1e-4)
    assert LI_2020.restoring_stiffness == pytest.approx(838.0, rel=1e-3)
    assert LI_2020.period == pytest.approx(6.02, abs=0.005)
    assert LI_2020.mass == pytest.approx(768.8, abs=0.05)
    assert LI_2020.contact_half_side == pytest.approx(177.0, abs=0.5)
    assert LI_2020.shares == (0.5, 0.5)


def test_the_square_contact_has_the_area_of_the_round_one():
    area = (2.0 * LI_2020.contact_half_side) ** 2
    assert area == pytest.approx(math.pi * 200.0**2)


def test_unequal_radii_share_the_travel():
    bearing = Bearing((6000.0, 3000.0), 400.0, 60.0, 1.9e6)
    assert bearing.shares == pytest.approx((2 / 3, 1 / 3))
    assert bearing.effective_radius == 9000.0


@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf, "a", True, None])
@pytest.mark.parametrize("place", range(4))
def test_numbers_that_are_not_positive_are_refused(place, value):
    arguments = [4500.0, 400.0, 60.0, 1.9e6]
    arguments[place] = value
    with pytest.raises(InputError, match="must be a number"):
        Bearing((arguments[0], 4500.0), *arguments[1:])


def test_a_slider_wider_than_the_sphere_is_refused():
    with pytest.raises(InputError, match="slider diameter"):
        Bearing((150.0,), 400.0, 60.0, 1.9e6)


def test_an_empty_file_is_the_paper(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text("")
    read = read_bearing(path)
    assert read.bearing.radii == LI_2020.radii
    assert read.friction == Li2020()
    assert read.heating == SimplifiedHeating()


def test_everything_can_be_given(tmp_path):
    path = tmp_path / "own.toml"
    path.write_text(
        'name = "Tower A"\nradii = [3000, 2500.0]\nslider = 350\npressure = 45\nstiffness = 1200\ncapacity = 500\n'
        '[friction]\nlaw = "kumar2015"\nmu_reference = 0.06\nreference_pressure = 50.0\n'
        '[heating]\nmodel = "precise"\nconductivity = 18.0\ndiffusivity = 4.44\nambient = -10\ncells = 32\n'
    )
    read = read_bearing(path)
    assert read.bearing == Bearing((3000.0, 2500.0), 350, 45, 1.2e6, 500, "", "Tower A")
    assert read.friction == Kumar2015(0.06, 50.0)
    assert read.heating == PreciseHeating(18.0, 4.44, -10, 32)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("radius = 0", "radius: effective radius .* must be a number of mm"),
        ("radius = -4500", "radius: effective radius"),
        ('radius = "big"', "radius: effective radius"),
        ("radius = 4500\nradii = [4500]", "either radius or radii"),
        ("radii = []", "a number of mm, or 2 of them, .* not 0 of them"),
        ("radius = 4.5", "were m meant"),
        ("slider = 0.4", "were m meant"),
        ("pressure = 60000", "were kPa meant"),
        ("stiffness = 1.9", "were MN/mm meant"),
        ('radius = "4.5 kg"', "not compatible"),
        ("pressure = nan", "pressure on the slider"),
        ('stiffness = "stiff"', "stiffness before sliding"),
        ("diameter = 400", "no parameter of a bearing 'diameter'"),
        ("friction = 0.05", "must be a table"),
        ('[friction]\nlaw = "lii2020"', "did you mean"),
        ("[friction]\nmu_0 = 2.0", "above 0 and up to"),
        ('[heating]\nmodel = "hot"', "no heating model"),
        ("[heating]\ncells = 5", "no parameter of the heating model simplified 'cells'"),
        ("[heating]\nconductivity = 0", "conductivity"),
        ("radius = = 3", "not TOML"),
    ],
)
def test_bad_files_get_one_sentence_that_names_them(tmp_path, text, words):
    path = tmp_path / "bad.toml"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        read_bearing(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_files_that_are_not_there_or_not_text(tmp_path):
    with pytest.raises(InputError, match="no such file"):
        read_bearing(tmp_path / "none.toml")
    with pytest.raises(InputError, match="this is a folder"):
        read_bearing(tmp_path)
    binary = tmp_path / "binary.toml"
    binary.write_bytes(bytes(range(256)))
    with pytest.raises(InputError, match="not TOML"):
        read_bearing(binary)


def test_heating_constants_are_the_papers():
    model = heating_model("simplified")
    assert model.conductivity == 16.0
    # 1 N/(mm s) is 1e-3 W/mm2: with the paper's k in W/(mm degC) and q in W/mm2 the rise is the same
    rise = constant_flux_rise(model, 750.0, 4.0)
    assert rise == pytest.approx(2.0 * 0.750 / 0.016 * math.sqrt(4.07 * 4.0 / math.pi))


@pytest.mark.parametrize("cells", [1, 0, -3, 2.5, True])
def test_a_senseless_number_of_cells_is_refused(cells):
    with pytest.raises(InputError, match="number of cells"):
        PreciseHeating(cells=cells)
