"""Records of the paper that do not come with the package, found in a folder."""

from pathlib import Path

import pytest
from peer_files import write_peer
from samples import sample_folder

from dcfp.errors import InputError
from dcfp.motion.treatment import treated
from dcfp.verify.paper_records import find_paper_records

KOBE = "Kobe Japan, 1/16/1995"


@pytest.fixture
def kobe(tmp_path: Path) -> Path:
    """JMA Kobe: the vertical component has the printed PGV, and the one after it is nearest to it; another station has it too."""
    write_peer(tmp_path / "RSN1106_KOBE_KJM000.AT2", f"{KOBE}, KJMA, 0", 911.0)
    write_peer(tmp_path / "RSN1106_KOBE_KJM090.AT2", f"{KOBE}, KJMA, 90", 750.0)
    write_peer(tmp_path / "RSN1106_KOBE_KJM-UP.AT2", f"{KOBE}, KJMA, UP", 893.0)
    write_peer(tmp_path / "KAK000.AT2", f"{KOBE}, KAKOGAWA, 0", 893.0)
    return tmp_path


def test_of_two_horizontal_components_the_one_whose_pgv_is_nearest(kobe: Path) -> None:
    found = find_paper_records(kobe)
    assert {name: round(motion.peak_velocity) for name, motion in found.motions.items()} == {"JKB": 911}
    assert found.motions["JKB"].name == "JKB"
    assert "RSN1106_KOBE_KJM000.AT2" in found.choices["JKB"]
    assert "of 2 horizontal" in found.choices["JKB"]
    assert found.left_out == ()


def test_a_file_that_is_no_record_is_named_and_left_out(kobe: Path) -> None:
    (kobe / "notes.txt").write_text("of no use")
    (kobe / "more").mkdir()
    (remark,) = find_paper_records(kobe).left_out
    assert "left out" in remark
    assert "notes.txt" in remark


def test_another_day_or_station_is_another_record(tmp_path: Path) -> None:
    write_peer(tmp_path / "one.AT2", "Tohoku Japan, 4/7/2011, JMA Sendai, 0", 545.0)
    write_peer(tmp_path / "two.AT2", f"{KOBE}, Kobe University, 0", 893.0)
    write_peer(tmp_path / "three.AT2", "Chi-Chi Taiwan-03, 9/25/1999, TCU129, E", 554.0)
    with pytest.raises(InputError, match=r"none of its 3 files .* JKB=FILE"):
        find_paper_records(tmp_path)
    write_peer(tmp_path / "four.AT2", "Tohoku Japan, 3/11/2011, JMA Sendai, 0", 400.0)
    write_peer(tmp_path / "five.AT2", "CHI-CHI 09/20/99, TCU129, E", 400.0)
    assert set(find_paper_records(tmp_path).motions) == {"TSD", "TC1"}


def test_a_file_may_have_the_name_of_its_record(tmp_path: Path) -> None:
    write_peer(tmp_path / "tim.AT2", "unknown, , somewhere, 0", 376.0)
    assert set(find_paper_records(tmp_path).motions) == {"TIM"}


def test_the_pgv_is_compared_after_the_treatment(tmp_path: Path) -> None:
    """An offset gives the right component a PGV of its own, and the wrong one the printed PGV."""
    write_peer(tmp_path / "a.AT2", f"{KOBE}, KJMA, 0", 893.0, offset=150.0)
    write_peer(tmp_path / "b.AT2", f"{KOBE}, KJMA, 90", 600.0, offset=40.0)

    def chosen(**how: float) -> str:
        return find_paper_records(tmp_path, lambda motion: treated(motion, **how)).motions["JKB"].origin.component  # fmt: skip

    assert chosen() == "90"
    assert chosen(baseline=True) == "0"


def test_no_folder() -> None:
    with pytest.raises(InputError, match="no such folder"):
        find_paper_records(Path("nowhere"))


@pytest.mark.skipif(sample_folder() is None, reason="needs the sample records")
def test_jma_kobe() -> None:
    folder = sample_folder()
    assert folder is not None
    motion = find_paper_records(folder / "paper").motions["JKB"]
    assert motion.peak_velocity == pytest.approx(911.0, abs=0.5)
