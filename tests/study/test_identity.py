"""By what two studies are told apart."""

from pathlib import Path

import pytest

import dcfp
from dcfp.analysis.integration import Integration
from dcfp.study import Sampling, Study, Uniform, run_study
from dcfp.study.store import digest

pytestmark = pytest.mark.filterwarnings("error")


@pytest.mark.parametrize(
    "change",
    [
        {"factors": {"mu": [0.05, 0.06]}},
        {"factors": {"mu": [0.05], "ambient": [20.0]}},
        {"settings": Integration(tolerance=0.03)},
        {"settings": Integration(tail=3.0)},
        {"model": dcfp.system.System(heating=dcfp.NoHeating())},
        {"histories": ("displacement",)},
        {"sampling": Sampling({"radius": Uniform(2000.0, 4000.0)}, 4)},
    ],
)
def test_whatever_changes_a_number_makes_another_study(motions, change: dict) -> None:
    same = {"motions": motions, "factors": {"mu": [0.05]}}
    digests = {digest(Study(**given).plan) for given in (same, same | change, same | {"title": "Another"})}
    assert len(digests) == 2


def test_a_motion_that_differs_makes_another_study(motions) -> None:
    one = Study(motions=motions)
    other = Study(motions=[motions[0].scaled(1.0 + 1e-15), *motions[1:]])
    assert digest(one.plan) != digest(other.plan)


def test_the_results_say_of_which_study_they_are(motions) -> None:
    study = Study(motions=motions[:1])
    assert run_study(study).attrs["study_sha256"] == digest(study.plan)


FACTOR = 0.05


def of_global(pressure: float, speed: float, temperature: float) -> float:
    return FACTOR


def law_of(value: float, other=None):
    """Return a law that takes its coefficient from around it."""

    def mu(pressure: float, speed: float, temperature: float) -> float:
        return value

    return dcfp.UserFriction(mu)


@pytest.mark.slow
def test_laws_of_a_user_are_told_apart_by_what_they_use(motions, monkeypatch) -> None:
    def digest_of(friction: dcfp.UserFriction) -> str:
        return digest(Study(motions[:1], model=dcfp.system.System(friction=friction)).plan)

    assert digest_of(law_of(0.05)) == digest_of(law_of(0.05))
    assert digest_of(law_of(0.05)) != digest_of(law_of(0.15))
    before = digest_of(dcfp.UserFriction(of_global))
    monkeypatch.setitem(globals(), "FACTOR", 0.06)
    assert digest_of(dcfp.UserFriction(of_global)) != before


def test_a_bearing_file_is_known_by_what_is_in_it(tmp_path: Path, record_file: Path) -> None:
    """From wherever and under whatever name the folder is looked at."""
    import shutil

    text = f'[factors]\nrecord = ["{record_file.name}"]\nbearing = ["b.toml"]\n[motion]\nunits = "m/s2"\n'
    folder = tmp_path / "one"
    folder.mkdir()
    (folder / "s.toml").write_text(text, encoding="utf-8")
    (folder / "b.toml").write_text("radius = 3000\n", encoding="utf-8")
    shutil.copy(record_file, folder)
    shutil.copytree(folder, tmp_path / "two")
    one = run_study(dcfp.read_study(folder / "s.toml"))
    two = run_study(dcfp.read_study(tmp_path / "two" / ".." / "two" / "s.toml"))
    assert one.attrs["study_sha256"] == two.attrs["study_sha256"]
    assert one["bearing"].values.tolist() == ["b.toml"]
    (folder / "b.toml").write_text("radius = 3500\n", encoding="utf-8")
    assert run_study(dcfp.read_study(folder / "s.toml")).attrs["study_sha256"] != one.attrs["study_sha256"]
