"""Each format: a small file made here is read as what was written."""

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.motion.load import read_motion, read_motions


def test_values_and_time_step(made, written):
    motions = read_motions(written(made, made.content), **made.options)
    assert [motion.origin.component for motion in motions] == list(made.components)
    for motion, values in zip(motions, made.components.values(), strict=True):
        np.testing.assert_allclose(motion.acceleration, values, rtol=1e-12, atol=1e-12)
        assert motion.time_step == pytest.approx(made.time_step, rel=1e-9)


def test_origin_is_filled(made, written):
    for motion in read_motions(written(made, made.content), **made.options):
        assert motion.origin.file_format
        assert motion.origin.processing
        assert motion.origin.source == made.name
        assert motion.treatment == ()


def test_each_component_by_its_label(made, written):
    path = written(made, made.content)
    for label, values in made.components.items():
        motion = read_motion(path, label.lower() or None, **made.options)
        np.testing.assert_allclose(motion.acceleration, values, rtol=1e-12, atol=1e-12)


def test_no_component_chosen(made, written):
    path = written(made, made.content)
    if len(made.components) == 1:
        read_motion(path, **made.options)
    else:
        with pytest.raises(InputError, match="choose one of") as raised:
            read_motion(path, **made.options)
        for label in made.components:
            assert repr(label) in str(raised.value)


def test_unknown_component(made, written):
    with pytest.raises(InputError, match=r"no component 'sideways'.*choose one of"):
        read_motion(written(made, made.content), "sideways", **made.options)


@pytest.mark.parametrize(
    ("name", "asked", "label"),
    [
        ("csmip", "NS", "360 Deg"),
        ("csmip", "ew", "90 Deg"),
        ("csmip", "UD", "Up"),
        ("csmip", "3", "90 Deg"),
        ("csmip", "chan 1", "360 Deg"),
        ("csmip", "360", "360 Deg"),
        ("cosmos", "2", "UP"),
        ("cosmos", "ud", "UP"),
        ("cwb", "NS", "N"),
        ("cwb", "u-d", "U"),
        ("esm", "EW", "HNE"),
        ("esm", "E", "HNE"),
        ("knet", "ns", "N-S"),
        ("kiknet", "EW", "EW2"),
        ("kiknet", "5", "EW2"),
        ("jma", "E-W", "EW"),
    ],
)
def test_component_by_direction_or_number(name, asked, label, make_file, written):
    made = make_file(name)
    assert read_motion(written(made, made.content), asked).origin.component == label


def test_the_extension_does_not_matter(made, tmp_path):
    path = tmp_path / "record.xyz"
    path.write_bytes(made.content)
    assert len(read_motions(path, **made.options)) == len(made.components)


def test_windows_and_old_mac_ends_of_line(made, written):
    plain = made.content.replace(b"\r\n", b"\n")
    for end in (b"\r\n", b"\r"):
        motion = read_motions(written(made, plain.replace(b"\n", end)), **made.options)[0]
        np.testing.assert_allclose(motion.acceleration, next(iter(made.components.values())), rtol=1e-12)


def test_own_unit_must_agree(made, written):
    if made.options:
        pytest.skip("a plain file states no unit")
    path = written(made, made.content)
    with pytest.raises(InputError, match="states its own unit"):
        read_motions(path, units="m/s2")
    with pytest.raises(InputError, match="states its own time step"):
        read_motions(path, time_step=0.03)
    unit = "G" if made.name.endswith("AT2") else "cm/s^2"
    assert read_motions(path, units=unit, time_step=made.time_step)


@pytest.mark.parametrize(
    ("name", "old", "new", "match"),
    [
        ("peer-nga", "43,", "1000000000000,", "truncated"),
        ("peer-nga", "43,", "9999999999999999999999999,", "NPTS and DT"),
        ("peer-nga", ".0050", ".0000", "time step"),
        ("peer-nga", ".0050", "1.0E9", "time step"),
        ("peer-nga", "ACCELERATION", "VELOCITY", "acceleration"),
        ("peer-nga", "OF G", "OF CM/S", "unit"),
        ("knet", "8223790", "0", "scale factor"),
        ("knet", "7845(gal)", "0(gal)", "scale factor"),
        ("knet", "7845(gal)", "1e30(gal)", "scale factor"),
        ("knet", "100Hz", "0Hz", "positive number"),
        ("knet", "100Hz", "Hz", "positive number"),
        ("knet", "Duration Time(s)  2", "Duration Time(s)  1000000000000", "promises"),
        ("knet", "N-S", "7", "direction"),
        ("knet", "Mag.", "Mug.", "line 5"),
        ("jma", "100Hz", "0Hz", "positive number"),
        ("jma", "gal(cm/s/s)", "volt", "unit"),
        ("jma", "NS,EW,UD", "NS,NS,UD", "twice"),
        ("csmip", "(8f10.5)", "(eight)", "format"),
        ("csmip", "cm/sec2", "inch", "unit"),
        ("csmip", ".005 sec", "0. sec", "time step"),
        ("cosmos", "cm/sec2(04)", "counts(50)", "acceleration in cm/s2 or g"),
        ("cosmos", "cm/sec2(04)", "cm/sec2(02)", "contradicts its code"),
        ("cosmos", "acceleration pts", "velocity pts", "no acceleration"),
        ("cosmos", "acceleration pts", "voltage pts", "acceleration in cm/s2 or g"),
        ("cosmos", "approx    0 secs", "approx    90 secs", "do not last"),
        ("cosmos", "Real-header values", "Unreal header values", "real header"),
        ("esm", "cm/s^2", "cm/s", "acceleration was expected"),
        ("esm", "DATA_TYPE: ACC", "DATA_TYPE: DEC", "acceleration was expected"),
        ("esm", "NDATA: 50", "NDATA: ", "no entry 'NDATA'"),
        ("esm", "0.005000", "-0.005", "positive number"),
        ("cwb", "SampleRate(Hz): 50", "SampleRate(Hz): 0", "positive number"),
        ("cwb", "gal. DC", "mile. DC", "unit"),
        ("cwb", "U(+); N(+); E(+)", "U(+); N(+); Q(+)", "columns"),
        ("cwb", "     0.040", "     0.050", "equally spaced"),
    ],
)
def test_damaged_header(name, old, new, match, make_file, written):
    made = make_file(name)
    assert old.encode() in made.content
    with pytest.raises(InputError, match=match):
        read_motions(written(made, made.content.replace(old.encode(), new.encode())))


def test_cosmos_time_step_is_that_of_the_series(make_file, written):
    """Real header 34, the recorder's step of 20 ms, must not be taken for header 62, 5 ms."""
    made = make_file("cosmos")
    assert read_motions(written(made, made.content))[0].time_step == 0.005


def test_cosmos_velocity_is_left_out(make_file, written):
    made = make_file("cosmos")
    first, second = made.components
    content = made.content.replace(
        b"acceleration pts, approx    0 secs, units=cm/sec2(04)",
        b"velocity pts, approx    0 secs, units=cm/sec(05)",
        1,
    )
    motions = read_motions(written(made, content))
    assert [motion.origin.component for motion in motions] == [second] != [first]


def test_processing_in_words(make_file, written):
    expected = {
        "peer-old": "0.1-40.0 Hz",
        "csmip": "band-pass .30-40.00 Hz, instrument and baseline corrected (header)",
        "cosmos": "band-pass 0.30-40.0 Hz, corrected (header)",
        "esm": "band-pass 0.100-30.000 Hz (Butterworth, order 2), baseline removed (header)",
        "knet": "offset not removed",
        "jma": "offset not removed",
        "cwb": "offset corrected (header)",
    }
    for name, words in expected.items():
        made = make_file(name)
        assert words in read_motions(written(made, made.content))[0].origin.processing
