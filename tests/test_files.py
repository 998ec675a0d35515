"""Files are written whole or not at all, with units."""

import csv
import os
import stat
from pathlib import Path

import pytest
import xarray

from dcfp import load_motion, respond
from dcfp.analysis import Response
from dcfp.errors import InputError
from dcfp.files import check_outputs, known_extension, whole_files
from dcfp.present.tables import group_names, write_responses


@pytest.fixture(scope="module")
def responses() -> list[Response]:
    motion = load_motion("NCC")
    return [respond(motion.scaled_to_pgv(pgv)) for pgv in (250.0, 500.0, 500.4)]


def test_outputs_that_can_be_written_pass(tmp_path: Path) -> None:
    check_outputs([tmp_path / "a.nc", tmp_path / "a.png"], overwrite=False)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("names", "inputs", "overwrite", "word"),
    [
        (["there.nc"], [], False, "exists"),
        (["none/a.nc"], [], False, "folder"),
        (["there.nc/a.nc"], [], False, "there.nc"),
        (["a.nc", "./a.nc"], [], False, "same name"),
        (["there.nc"], ["there.nc"], True, "input"),
        ([""], [], True, "folder"),
        (["a\0b.nc"], [], False, "a"),
        (["x" * 300 + ".nc"], [], False, "cannot be"),
    ],
)
def test_outputs_that_cannot(tmp_path: Path, names, inputs, overwrite: bool, word: str) -> None:
    (tmp_path / "there.nc").write_text("old")
    with pytest.raises(InputError, match=word):
        check_outputs(
            [tmp_path / name for name in names],
            overwrite=overwrite,
            inputs=[tmp_path / name for name in inputs],
        )


def test_a_device_is_no_output() -> None:
    if not Path(os.devnull).exists():
        pytest.skip("no such device")
    with pytest.raises(InputError, match="regular"):
        check_outputs([Path(os.devnull)], overwrite=True)


@pytest.mark.parametrize("error", [RuntimeError, KeyboardInterrupt, OSError])
def test_a_failure_in_the_middle_leaves_the_old_content(tmp_path: Path, error: type[BaseException]) -> None:
    old = tmp_path / "a.csv"
    old.write_text("precious")

    def write() -> None:
        with whole_files([old, tmp_path / "b.csv"], overwrite=True) as parts:
            parts[0].write_text("half of it")
            raise error

    with pytest.raises((error, InputError)):
        write()
    assert old.read_text() == "precious"
    assert list(tmp_path.iterdir()) == [old]


def test_a_file_that_appears_in_the_meantime_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"

    def write() -> None:
        with whole_files([path], overwrite=False) as parts:
            parts[0].write_text("mine")
            path.write_text("theirs")

    with pytest.raises(InputError, match="exists"):
        write()
    assert path.read_text() == "theirs"
    assert list(tmp_path.iterdir()) == [path]


@pytest.mark.skipif(os.name != "posix", reason="permissions are those of POSIX")
def test_permissions_are_those_of_a_new_file_or_of_the_old_one(tmp_path: Path) -> None:
    ordinary, new, old = (tmp_path / name for name in ("ordinary", "new", "old"))
    ordinary.write_text("")
    old.write_text("")
    old.chmod(0o640)
    with whole_files([new, old], overwrite=True):
        pass
    assert stat.S_IMODE(new.stat().st_mode) == stat.S_IMODE(ordinary.stat().st_mode)
    assert stat.S_IMODE(old.stat().st_mode) == 0o640


def test_a_link_keeps_pointing_to_its_file(tmp_path: Path) -> None:
    target, link = tmp_path / "target.csv", tmp_path / "link.csv"
    target.write_text("old")
    link.symlink_to(target)
    with whole_files([link], overwrite=True) as parts:
        parts[0].write_text("new")
    assert link.is_symlink()
    assert target.read_text() == "new"


def test_known_extensions() -> None:
    assert known_extension("a.NC", (".nc",), "data") == Path("a.NC")
    with pytest.raises(InputError, match=r"a\.xls.*\.nc, \.csv"):
        known_extension("a.xls", (".nc", ".csv"), "data")


def test_netcdf_of_one_analysis_comes_back_as_it_was(tmp_path: Path, responses) -> None:
    write_responses(tmp_path / "a.nc", responses[1:2], ".nc")
    with xarray.open_dataset(tmp_path / "a.nc") as data:
        xarray.testing.assert_identical(data.load(), responses[1].to_dataset())


@pytest.mark.slow
def test_netcdf_of_several_has_a_summary_and_a_group_for_each(tmp_path: Path, responses) -> None:
    write_responses(tmp_path / "a.nc", responses, ".nc")
    with xarray.open_datatree(tmp_path / "a.nc") as tree:
        assert list(tree.children) == group_names(responses) == ["NCC_0.25", "NCC_0.50", "NCC_0.5004"]
        for node in tree.subtree:
            for name, variable in node.dataset.variables.items():
                if variable.dtype.kind == "f":
                    assert variable.attrs["units"], name
                    assert variable.attrs["long_name"], name
        assert float(tree["y_max"].sel(analysis="NCC_0.50")) == responses[1].peak_displacement
        assert float(tree["force_max"][0]) == pytest.approx(responses[0].peak_force / 1e3)
    with xarray.open_dataset(tmp_path / "a.nc") as summary:
        assert dict(summary.sizes) == {"analysis": 3}
        assert summary["record"].to_numpy().tolist() == ["NCC"] * 3


def test_names_of_groups_are_safe_and_different(responses) -> None:
    from dataclasses import replace

    odd = replace(responses[0], motion=replace(responses[0].motion, name="a/b c"))
    assert group_names([odd, odd]) == ["a-b-c_0.25", "a-b-c_0.25_2"]


def test_csv_of_one_analysis_is_its_histories(tmp_path: Path, responses) -> None:
    write_responses(tmp_path / "a.csv", responses[:1], ".csv")
    with (tmp_path / "a.csv").open(newline="") as stream:
        rows = list(csv.reader(stream))
    assert rows[0][:4] == [
        "time [s]",
        "ground_acceleration [mm s-2]",
        "ground_velocity [mm s-1]",
        "displacement [mm]",
    ]
    assert len(rows) == responses[0].time.size + 1
    peak = max(abs(float(row[3])) for row in rows[1:])
    assert peak == pytest.approx(responses[0].peak_displacement, rel=1e-3)


def test_csv_of_several_is_the_summary(tmp_path: Path, responses) -> None:
    write_responses(tmp_path / "a.csv", responses, ".csv")
    with (tmp_path / "a.csv").open(newline="") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["record"] for row in rows] == ["NCC"] * 3
    assert float(rows[1]["y_max [mm]"]) == pytest.approx(responses[1].peak_displacement)
    assert rows[0]["status"] == "ok"
