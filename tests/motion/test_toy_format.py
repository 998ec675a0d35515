"""A record format that one module outside of the package adds is read at every door, and listed where formats are."""

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

import dcfp
from dcfp.doors.cli.main import main
from dcfp.errors import InputError
from dcfp.motion.formats.registry import FORMATS
from dcfp.motion.load import load_motion

HERE = Path(__file__).parent


@pytest.fixture
def toy(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Add the format for a test."""
    monkeypatch.syspath_prepend(HERE)
    import_module("toy_format")
    yield
    FORMATS.remove("TOY")
    del sys.modules["toy_format"]


@pytest.fixture
def record(tmp_path: Path) -> Path:
    """A second of a sine with a period of 0.4 s."""
    values = np.round(3000.0 * np.sin(5.0 * np.pi * np.arange(101) / 100.0)).astype(int)
    path = tmp_path / "swing.toy"
    path.write_text(f"TOY 100 {values.size}\n" + "\n".join(map(str, values)))
    return path


def test_without_its_module_the_file_is_in_no_known_format(record: Path) -> None:
    with pytest.raises(InputError, match="none of the known record formats"):
        load_motion(record)


@pytest.mark.usefixtures("toy")
def test_it_is_read(record: Path) -> None:
    motion = load_motion(f"{record}::x")
    assert motion.name == "swing"
    assert motion.time_step == 0.01
    assert motion.peak_acceleration == 3000.0
    assert (motion.origin.file_format, motion.origin.component) == ("TOY", "X")
    assert motion.origin.citation == "Toys Inc."
    with pytest.raises(InputError, match=r"the TOY file states its own unit, mm/s2; leave out units='g'"):
        load_motion(record, units="g")
    record.write_text(record.read_text().rpartition("\n")[0])
    with pytest.raises(InputError, match="promises 101 values but only 100 are there"):
        load_motion(record)


@pytest.mark.usefixtures("toy")
def test_the_command_line(record: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["respond", str(record), "--json"]) == 0
    (response,) = json.loads(capsys.readouterr().out)
    assert response["record"] == "swing"
    assert response["y_max_mm"] == pytest.approx(dcfp.respond(record).summary()["y_max_mm"])
    assert main(["records", str(record)]) == 0
    assert "(TOY)" in capsys.readouterr().out


@pytest.mark.slow
def test_an_installed_package_adds_it_by_its_entry_point(record: Path, tmp_path: Path) -> None:
    about = tmp_path / "toys-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: toys\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[dcfp.plugins]\nformat = toy_format\n")
    (tmp_path / "toy_format.py").write_text((HERE / "toy_format.py").read_text())
    source = str(Path(dcfp.__file__).parents[1])
    environment = os.environ | {"PYTHONPATH": os.pathsep.join((str(tmp_path), source))}
    command = [sys.executable, "-m", "dcfp.doors.cli.main", "respond", str(record), "--json"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    (response,) = json.loads(done.stdout)
    assert response["record"] == "swing"


@pytest.mark.usefixtures("toy")
def test_the_page_takes_it(record: Path) -> None:
    pytest.importorskip("nicegui", reason="the web page needs nicegui")
    from dcfp.doors.app.fields import upload_words
    from dcfp.doors.app.session import read_upload

    assert "TOY" in upload_words()
    (upload,) = read_upload(record.read_bytes(), record.name)
    assert upload.motion.origin.file_format == "TOY"


@pytest.mark.usefixtures("toy")
def test_the_documentation_lists_it(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("sphinx", reason="the documentation needs Sphinx")
    monkeypatch.syspath_prepend(HERE.parents[1] / "docs" / "_extensions")
    listed = import_module("declared").format_table()
    assert "| TOY | nobody's: made for a test |" in listed
    assert "| PEER AT2 |" in listed
