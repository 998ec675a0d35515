"""Where components point, from their labels."""

import pytest

from dcfp.motion.formats.directions import azimuth, direction, points_down

LABELS = {
    "N-S": 0.0, "NS2": 0.0, "North": 0.0, "N (CWB)": 0.0, "000 (USGS STATION 117)": 0.0, "360 Deg": 0.0, "0": 0.0, "HNN": 0.0,
    "E-W": 90.0, "EW1": 90.0, "WE": 90.0, "090": 90.0, "90 deg": 90.0, "BHE": 90.0, "H1 90": 90.0, "CHICHI/CHY101-E": 90.0,
    "S": 180.0, "W (CWB)": 270.0, "N00E": 0.0, "N30E": 30.0, "N30W": 330.0, "S30E": 150.0, "S16E": 164.0, "S74W": 254.0,
    "067": 67.0, "337": 337.0, "12.5": 12.5, "9 deg": 9.0, "NORTHR/LOS270": 270.0, "IMPVALL/H-E06_233": 233.0, "IMPVALL/H-E11140": 140.0,
}  # fmt: skip
UNKNOWN = ("", "1", "2", "H1", "H2", "channel 2", "BH100", "a", "x", "LANDERS/CLW-LN", "UPLAND", "Vernon", "400", "Zack", "Downey", "SHE009", "-1")  # fmt: skip
UP = ("U-D", "UD", "UP", "-UP", "Up", "U", "V", "Z", "Vert", "VERTICAL", "HNZ", "BNZ", "UD2", "UD1", "DWN", "Down", "TABAS/TAB-UP")  # fmt: skip


@pytest.mark.parametrize(("label", "degrees"), LABELS.items())
def test_labels_that_plainly_tell(label: str, degrees: float) -> None:
    assert azimuth(label) == pytest.approx(degrees)
    assert direction(label) == {0.0: "NS", 90.0: "EW"}.get(degrees if direction(label) else -1.0)


@pytest.mark.parametrize("label", UNKNOWN)
def test_labels_that_do_not(label: str) -> None:
    assert azimuth(label) is direction(label) is None


@pytest.mark.parametrize("label", UP)
def test_labels_of_vertical_components(label: str) -> None:
    assert direction(label) == "UD"
    assert azimuth(label) is None
    assert points_down(label) == (label[0] == "D")
