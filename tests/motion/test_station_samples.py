"""Stations of real records, in every form in which they are given."""

import pytest

from dcfp import InputError, load_motion, load_station, respond
from dcfp.motion.station import Station

#: What is given, in the folder of samples; where x and y point; whether there is a vertical component.
GIVEN = [
    ("knet", (90.0, 0.0), True),
    ("knet/AOM0031801241951", (90.0, 0.0), True),
    ("kiknet", (90.0, 0.0), True),
    ("jma/tokyo_5_1.csv::NS+::EW+::UD", (0.0, 90.0), True),
    ("csmip_v2/CE89146.V2::360 Deg+::90 Deg+::Up", (0.0, 90.0), True),
    ("csmip_v2/CE58667.V2::H1+::H2+::Up", None, True),
    ("cwb/1-EAS.dat::E+::N+::U", (90.0, 0.0), True),
    ("esm/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC+{}/esm/HI.ARS1..HNN.D.20190728.160908.C.ACC.ASC", (90.0, 0.0), False),
    ("paper/RSN1106_KOBE_KJM000.AT2+{0}/paper/RSN1106_KOBE_KJM090.AT2+{0}/paper/RSN1106_KOBE_KJM-UP.AT2", (0.0, 90.0), True),
    ("peer_old/RSN763_LOMAP_GIL067.AT2+{}/peer_old/RSN763_LOMAP_GIL337.AT2", (67.0, 337.0), False),
    ("peer_old/TAP084-N.AT2+{}/peer_old/TAP084-W.AT2", (0.0, 270.0), False),
    ("peer_old/RSN20075_40199209_1826HNE.AT2+{}/peer_old/RSN20075_40199209_1826HNN.AT2", (90.0, 0.0), False),
]  # fmt: skip


@pytest.mark.parametrize(
    ("given", "azimuths", "has_vertical"),
    [pytest.param(*one, id=one[0][:20], marks=pytest.mark.slow if "::" in one[0] else ()) for one in GIVEN],
)
def test_a_real_station(samples, given, azimuths, has_vertical) -> None:
    found = load_station(f"{samples}/{given.format(samples)}")
    assert isinstance(found, Station)
    assert found.azimuths == azimuths
    assert (found.vertical is not None) == has_vertical
    assert found.treatment == ()  # recorded together
    assert found.peak_velocity >= max(found.x.peak_velocity, found.y.peak_velocity) > 0.0


@pytest.mark.slow
def test_when_real_records_begin(samples) -> None:
    for file, component, start in (
        ("knet/AOM0031801241951.EW", None, "2018-01-24T19:51:23+09:00"),
        ("kiknet/AICH040010061330.EW2", None, "2000-10-06T13:31:09+09:00"),
        ("jma/tokyo_5_1.csv", "NS", "2011-03-11T14:47:10+09:00"),
        ("csmip_v2/CE89146.V2", "Up", "2012-02-13T21:06:45+00:00"),
        ("cwb/1-EAS.dat", "E", "2018-02-06T23:50:29+08:00"),
        ("esm/HI.ARS1..HNE.D.20190728.160908.C.ACC.ASC", None, "2019-07-28T16:09:19.870000+00:00"),
        ("cosmos/Cosmos12TimeSeriesTest.v1", None, "2005-06-16T20:53:04.400000+00:00"),
        (
            "cosmos/us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c",
            None,
            "2018-11-30T17:29:39.137000+00:00",
        ),
        ("paper/RSN1106_KOBE_KJM000.AT2", None, ""),
    ):
        assert load_motion(samples / file, component).origin.start == start, file


@pytest.mark.parametrize("file", ["knet/AOM0031801241951.UD", "paper/RSN1106_KOBE_KJM-UP.AT2", "cosmos/us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c"])  # fmt: skip
def test_a_real_vertical_component_is_refused_as_horizontal(samples, file) -> None:
    with pytest.raises(InputError, match="is a vertical component"):
        respond(samples / file)


def test_real_records_that_are_not_of_one_station(samples) -> None:
    with pytest.raises(InputError, match="are of different stations, 'TAP084' and 'TAP094'"):
        load_station(f"{samples}/peer_old/TAP084-N.AT2+{samples}/peer_old/TAP094-E.AT2")
    with pytest.raises(InputError, match="are of different earthquakes"):
        load_station(f"{samples}/knet/AOM0031801241951.EW+{samples}/kiknet/AICH040010061330.NS2")
