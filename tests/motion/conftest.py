"""Record files to read: small ones made here for each format, and samples where they are at hand."""

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from samples import sample_folder

STANDARD_GRAVITY = 9806.65


@dataclass(frozen=True)
class MadeFile:
    """A file made by a test, what it must be read as, and how."""

    name: str
    content: bytes
    time_step: float
    components: dict[str, np.ndarray]
    first_value_line: int
    counted: bool = True
    options: dict[str, Any] = field(default_factory=dict)


def wave(points: int, seed: int, size: float) -> np.ndarray:
    """A damped oscillation with some noise, rounded as printed."""
    random = np.random.default_rng(seed)
    time = np.arange(points)
    values = size * np.sin(0.4 * time + seed) * np.exp(-0.02 * time) + 0.05 * size * random.normal(
        size=points
    )
    return np.round(values, 5)


def rows(values: np.ndarray, per_line: int, width: int, decimals: int) -> str:
    """Fields of fixed width, as many on a line as the format says."""
    words = [f"{value:{width}.{decimals}f}" for value in values]
    return "".join("".join(words[i : i + per_line]) + "\n" for i in range(0, len(words), per_line))


def peer(header: str) -> Callable[[], MadeFile]:
    def make() -> MadeFile:
        values = wave(43, 1, 0.3)
        words = [f"{value:15.7E}" for value in values]
        body = "".join("".join(words[i : i + 5]) + "\n" for i in range(0, len(words), 5))
        title = "PEER NGA STRONG MOTION DATABASE RECORD\nKobe_ Japan, 1/16/1995, Nishi-Akashi, 0"
        text = f"{title}\n{header}\n{body}"
        return MadeFile(
            "peer.AT2", text.encode(), 0.005, {"0": values * STANDARD_GRAVITY}, 3 + header.count("\n") + 1
        )

    return make


def kyoshin(direction: str, label: str) -> Callable[[], MadeFile]:
    def make() -> MadeFile:
        counts = np.round(wave(200, 2, 40000.0)) - 8800
        body = rows(counts, 8, 9, 0)
        text = (
            "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\n"
            "Depth. (km)       30\nMag.              6.2\nStation Code      AOM003\n"
            "Station Lat.      41.4053\nStation Long.     141.1691\nStation Height(m) 4\n"
            "Record Time       2018/01/24 19:51:38\nSampling Freq(Hz) 100Hz\nDuration Time(s)  2\n"
            f"Dir.              {direction}\nScale Factor      7845(gal)/8223790\n"
            "Max. Acc. (gal)   17.338\nLast Correction   2018/01/24 19:51:38\nMemo.             \n"
        )
        return MadeFile(
            "AOM003.NS", (text + body).encode(), 0.01, {label: counts * (7845 / 8223790 * 10.0)}, 18
        )

    return make


def jma() -> MadeFile:
    table = np.round(np.column_stack([wave(50, seed, 200.0) for seed in (1, 2, 3)]), 3)
    text = (
        "SITE CODE= 47662東京千代田区大手町        ,35.69,139.76\n LAT.=   35.6890\n LON.=  139.7559\n"
        " SAMPLING RATE= 100Hz\n UNIT  = gal(cm/s/s)\nINITIAL TIME = 2011 03 11 14 47 10\n NS,EW,UD\n"
    )
    body = "".join(",".join(f"{value:.3f}" for value in row) + "\n" for row in table)
    components = {name: table[:, i] * 10.0 for i, name in enumerate(("NS", "EW", "UD"))}
    return MadeFile("tokyo.csv", (text + body).encode("cp932"), 0.01, components, 8, counted=False)


def csmip() -> MadeFile:
    text, components = "", {}
    for number, label in enumerate(("360 Deg", "Up", "90 Deg"), 1):
        values = wave(43, number, 50.0)
        # Six decimals in ten columns, so that negative numbers of three digits run together.
        values[5] = -123.45678
        components[label] = values * 10.0
        text += (
            f"Corrected accelerogram   89146-L2500-12044.02       Chan  {number}: {label}     from\r\n"
            "Uncorrected Accelerogram Data             Processed: 02/13/12, CGS  146be002\r\n"
            "Record of Mon Feb 13, 2012 13:06:45.0 PST             (Avol1 v9.2,12/11 CSMIP)\r\n"
            f"Willow Creek                              CGS\r\nChan  {number}: {label}\r\n"
            "Accelerogram bandpass filtered with 3 dB pts at   .30 and 40.00 cyc/sec\r\n"
            "    43 points of instrument- and baseline-corrected accel, veloc and displ data\r\n"
        )
        for quantity, unit in (("accel", "cm/sec2"), ("veloc", "cm/sec"), ("displ", "cm")):
            text += f"    43 points of {quantity} data equally spaced at  .005 sec, in {unit}. (8f10.5)\r\n"
            text += rows(values, 8, 10, 5).replace("\n", "\r\n")
        text += f"/&  ----------  End of data for channel  {number}  ----------\r\n"
    return MadeFile("CE89146.V2", text.encode(), 0.005, components, 9)


def cosmos() -> MadeFile:
    real = np.full(100, -999.0)
    real[33], real[61], real[62] = 0.02, 5.0, 0.215
    text, components = "", {}
    for number, label in enumerate(("340 deg", "UP"), 1):
        values = wave(43, number, 50.0)
        components[label] = values * 10.0
        text += (
            "Corrected acceleration    (Format v01.20 with 13 text lines)\n"
            "Record of Yucaipa Earthquake of Thu Jun 16, 2005 20:53 UTC\n"
            "Hypocenter: 34.0580  -117.0110  H= 12km(SCSN) ML=4.9\nOrigin: 06/16/2005, 20:53:26.1 UTC\n"
            "Statn No: 01-23075  Code:CE-J2236  CDMG Yucaipa - Bryant & Oak Glen\nCoords: 34.0460 -117.0350\n"
            "Recorder: SSA-2\nRcrd start time:06/16/2005, 20:53:04.400 UTC\n"
            f"Sta Chan  {number}: {label} (Rcrdr Chan  1) Location:\nRaw record length = 0.215 sec\n"
            "Processed: 06/17/2005\n"
            "Record filtered below 0.30  Hz (periods over  14.5 secs), and above 40.0 Hz\n"
            "Values used when parameter or data value is unknown/unspecified:   -999, -999.0\n"
            " 100 Integer-header values follow on  10 lines, Format= (10I8)\n"
            f"{rows(np.full(100, -999), 10, 8, 0)}"
            " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n"
            f"{rows(real, 6, 13, 6)}"
            '  1 Comment line(s) follow, each starting with a "|":\n| a comment\n'
            "     43 acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(8F10.5)\n"
            f"{rows(values, 8, 10, 5)}End-of-data for Chan {number} acceleration\n"
        )
    return MadeFile("yucaipa.V2c", text.encode(), 0.005, components, 46)


def esm() -> MadeFile:
    values = wave(50, 4, 20.0)
    text = (
        "EVENT_NAME: GREECE\nEVENT_DATE_YYYYMMDD: 20190728\nMAGNITUDE_W: \nMAGNITUDE_L: 4.6\nNETWORK: HI\n"
        "STATION_CODE: ARS1\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: 50\nDURATION_S: 0.25\nSTREAM: HNE\n"
        "UNITS: cm/s^2\nBASELINE_CORRECTION: BASELINE REMOVED\nFILTER_TYPE: BUTTERWORTH\nFILTER_ORDER: 2\n"
        "LOW_CUT_FREQUENCY_HZ: 0.100\nHIGH_CUT_FREQUENCY_HZ: 30.000\nHEADER_FORMAT: DYNA 1.2\n"
        "DATA_TYPE: ACCELERATION\nUSER1: \n"
    )
    body = "".join(f"{value:.6f}\n" for value in values)
    return MadeFile("HI.ARS1.ASC", (text + body).encode(), 0.005, {"HNE": values * 10.0}, 20)


def cwb() -> MadeFile:
    table = np.round(np.column_stack([wave(50, seed, 200.0) for seed in (1, 2, 3)]), 3)
    time = np.arange(50) * 0.02
    text = (
        "#Earthquake Information\r\n#Origin Time(GMT+08): 2018/02/06-23:50:42\r\n#Magnitude(Ml): 6.0\r\n\r\n"
        "#StationCode: EAS\r\n#StartTime(GMT+08): 2018/02/06-23:50:29.000\r\n#RecordLength(sec): 1\r\n"
        "#SampleRate(Hz): 50\r\n#AmplitudeUnit:  gal. DCoffset(corr)\r\n"
        "#DataSequence: Time U(+); N(+); E(+)\r\n#Data: 4F10.3 \r\n"
    )
    body = rows(np.column_stack([time, table]).ravel(), 4, 10, 3).replace("\n", "\r\n")
    components = {name: table[:, i] * 10.0 for i, name in enumerate("UNE")}
    return MadeFile("1-EAS.dat", (text + body).encode(), 0.02, components, 12)


def one_column() -> MadeFile:
    values = wave(30, 5, 2.0)
    text = "# made by a test\nacceleration\n" + "".join(f"{value:.5f}\n" for value in values)
    options = {"units": "m/s2", "time_step": 0.01}
    return MadeFile("one.txt", text.encode(), 0.01, {"": values * 1000.0}, 3, counted=False, options=options)


def two_columns(separator: str) -> Callable[[], MadeFile]:
    def make() -> MadeFile:
        values = wave(30, 6, 0.2)
        # A step of 1/128 s, which four decimals cannot show exactly.
        lines = (f"{i / 128.0:.4f}{separator}{value:.5f}\n" for i, value in enumerate(values))
        text = "time [s],acceleration [g]\n" + "".join(lines)
        components = {"": values * STANDARD_GRAVITY}
        options = {"units": "g"}
        return MadeFile("two.csv", text.encode(), 1 / 128, components, 2, counted=False, options=options)

    return make


MAKERS: dict[str, Callable[[], MadeFile]] = {
    "peer-nga": peer("ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=     43, DT=   .0050 SEC,      "),
    "peer-spaced": peer("ACCELERATION TIME SERIES IN UNITS OF G\nNPTS =  43 , DT =   .0050 SEC,"),
    "peer-old": peer(
        "ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.1 Hz LP=40.0 Hz\n"
        "NPTS= 43, DT= .00500 SEC"
    ),
    "peer-oldest": peer("ACCELERATION TIME HISTORY IN UNITS OF G\n    43    0.0050    NPTS, DT"),
    "knet": kyoshin("N-S", "N-S"),
    "kiknet": kyoshin("5", "EW2"),
    "jma": jma,
    "csmip": csmip,
    "cosmos": cosmos,
    "esm": esm,
    "cwb": cwb,
    "one-column": one_column,
    "two-columns": two_columns(","),
    "two-columns-blank": two_columns("   "),
}


def sample_files() -> list[Path]:
    folder = sample_folder()
    if folder is None:
        return []
    return sorted(path for path in folder.rglob("*") if path.is_file() and path.name != "INDEX.tsv")


def _one_of_each_kind(files: list[Path]) -> set[Path]:
    """Return the smallest sample of each folder, whose files are alike, and all of the odd ones."""
    smallest = {path.parent: path for path in sorted(files, key=lambda one: one.stat().st_size, reverse=True)}
    return {path for path in files if path.parent.name == "odd"} | set(smallest.values())


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    if "made" in metafunc.fixturenames:
        metafunc.parametrize("made", [make() for make in MAKERS.values()], ids=list(MAKERS), scope="session")
    if "sample" in metafunc.fixturenames:
        files = sample_files()
        if files:
            few = _one_of_each_kind(files)
            metafunc.parametrize(
                "sample",
                [
                    pytest.param(path, marks=[] if path in few else [pytest.mark.long], id=path.name)
                    for path in files
                ],
                scope="session",
            )
        else:
            skip = pytest.mark.skip(reason="no sample records: set DCFP_SAMPLE_RECORDS")
            metafunc.parametrize("sample", [pytest.param(None, marks=skip)], scope="session")


@pytest.fixture(scope="session")
def samples() -> Path:
    folder = sample_folder()
    if folder is None:
        pytest.skip("no sample records: set DCFP_SAMPLE_RECORDS")
    return folder


@pytest.fixture
def make_file() -> Callable[[str], MadeFile]:
    return lambda name: MAKERS[name]()


@pytest.fixture(scope="session")
def written(tmp_path_factory: pytest.TempPathFactory) -> Callable[[MadeFile | Path, bytes], Path]:
    """Write bytes under the name of a file, into a folder of its own."""
    folder = tmp_path_factory.mktemp("records")

    def write(file: MadeFile | Path, content: bytes) -> Path:
        path = folder / Path(file.name).name
        path.write_bytes(content)
        return path

    return write
