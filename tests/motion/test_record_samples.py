"""Real records: PGA and PGV of the index, those that the headers state, and a second reader."""

import csv
import re

import numpy as np
import pytest

from dcfp.motion.load import read_motion, read_motions
from dcfp.motion.measures import baseline_warning
from dcfp.motion.treatment import high_pass, remove_leading_mean, remove_mean

FILTERED = "pre-event mean removed + zero-phase Butterworth HP 0.05 Hz"


def index_rows(samples):
    with (samples / "INDEX.tsv").open(encoding="utf-8") as file:
        return [row for row in csv.DictReader(file, delimiter="\t") if row["PGA_m_s2"]]


def read_row(samples, row):
    """The motion of a row of the index, whose components are named in several ways."""
    motions = read_motions(samples / row["path"])
    label = re.sub(r"^Chan\s+\d+:\s*", "", row["component"]).strip()
    found = [motion for motion in motions if motion.origin.component == label]
    return found[0] if len(motions) > 1 else motions[0]


def test_index(samples):
    rows = index_rows(samples)
    assert len(rows) == 20
    for row in rows:
        motion = read_row(samples, row)
        treatment = row["baseline_treatment_of_the_PGV"]
        if treatment == FILTERED:
            motion = remove_leading_mean(motion, 5.0)
        assert motion.peak_acceleration / 1000.0 == pytest.approx(float(row["PGA_m_s2"]), rel=1e-3, abs=6e-5)
        if row["npts"]:
            assert motion.acceleration.size == int(row["npts"])
            assert motion.time_step == float(row["dt_s"])
        if row["PGV_m_s"]:
            if treatment == FILTERED:
                motion = high_pass(motion, 0.05, order=2)
            assert motion.peak_velocity / 1000.0 == pytest.approx(float(row["PGV_m_s"]), rel=4e-3, abs=6e-5)


@pytest.mark.parametrize("component", ["NS", "EW", "UD"])
@pytest.mark.parametrize("folder", ["knet", "kiknet"])
def test_header_peak_of_nied(samples, folder, component):
    """'Max. Acc.' is the largest distance from the mean."""
    path = next((samples / folder).glob(f"*.{component}*"))
    stated = float(re.search(r"Max\. Acc\. \(gal\)\s+(\S+)", path.read_text())[1])
    assert remove_mean(read_motion(path)).peak_acceleration / 10.0 == pytest.approx(stated, abs=6e-4)


def test_header_peak_of_csmip(samples):
    for path in (samples / "csmip_v2").iterdir():
        text = path.read_text()
        accelerations = re.findall(r"Peak acceleration =\s*(\S+)\s*cm/sec/sec", text)
        velocities = re.findall(r"Peak\s+velocity\s*=\s*(\S+)\s*cm/sec", text)
        motions = read_motions(path)
        assert len(motions) == len(accelerations) == 3
        for motion, a, v in zip(motions, accelerations, velocities, strict=True):
            assert motion.peak_acceleration / 10.0 == pytest.approx(abs(float(a)), abs=6e-4)
            # The agency's velocity does not start from rest; its header states the initial velocity.
            assert motion.peak_velocity / 10.0 == pytest.approx(abs(float(v)), rel=0.02)


def test_header_peak_of_cwb(samples):
    path = samples / "cwb" / "1-EAS.dat"
    text = path.read_text(encoding="latin-1")
    for direction in "UNE":
        high, low = re.search(rf"MAX\. {direction}:\s*(\S+?)~\s*(\S+)", text).groups()
        motion = read_motion(path, direction)
        assert motion.acceleration.max() / 10.0 == pytest.approx(float(high), abs=1e-9)
        assert motion.acceleration.min() / 10.0 == pytest.approx(float(low), abs=1e-9)
        assert motion.time_step == 0.02


def test_header_peak_of_esm(samples):
    for path in (samples / "esm").iterdir():
        stated = float(re.search(r"PGA_CM/S\^2: (\S+)", path.read_text())[1])
        motion = read_motion(path)
        assert motion.peak_acceleration / 10.0 == pytest.approx(abs(stated), abs=1e-6)


def test_header_peak_and_time_step_of_cosmos(samples):
    """The peak's time tells the time step of the series, 5 ms, from the recorder's, 20 ms."""
    for path, peak, time in (
        ("Cosmos12TimeSeriesTest.v1", -161.962, 27.85),
        ("us1000hyfh_akbmrp_AKBMR--n.1000hyfh.BNZ.--.acc.V2c", -6.851512, 76.215),
    ):
        motion = read_motion(samples / "cosmos" / path)
        place = int(np.argmax(np.abs(motion.acceleration)))
        assert motion.acceleration[place] / 10.0 == pytest.approx(peak, rel=1e-4)
        assert motion.time[place] == pytest.approx(time, abs=1e-9)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("folder", ["knet", "kiknet"])
def test_against_obspy(samples, folder):
    obspy = pytest.importorskip("obspy")
    for path in (samples / folder).iterdir():
        trace = obspy.read(str(path), format="KNET")[0]
        motion = read_motion(path)
        # obspy returns counts and, as calibration, the scale factor in m/s2.
        np.testing.assert_allclose(
            motion.acceleration, trace.data * trace.stats.calib * 1000.0, rtol=1e-12, atol=1e-12
        )
        assert motion.time_step == pytest.approx(trace.stats.delta, rel=1e-12)
        assert motion.origin.station == trace.stats.station


def test_raw_records_are_suspected_and_processed_ones_are_not(samples):
    for path in (samples / "knet").iterdir():
        raw = read_motion(path)
        assert "untreated baseline" in (baseline_warning(raw) or "")
        treated = high_pass(remove_leading_mean(raw, 5.0), 0.05)
        assert baseline_warning(treated) is None
        assert len(treated.treatment) == 2
    for folder in ("peer_at2", "esm", "csmip_v2", "cosmos"):
        for path in (samples / folder).iterdir():
            assert all(baseline_warning(motion) is None for motion in read_motions(path))
