"""The list of mutations keeps up with the source."""

import pytest

from .mutations import MUTATIONS, ROOT, Mutation


@pytest.mark.parametrize("mutation", MUTATIONS, ids=lambda one: one.name)
def test_every_mutation_finds_its_place(mutation: Mutation) -> None:
    source = (ROOT / "src" / "dcfp" / mutation.file).read_text(encoding="utf-8")
    assert mutation.applied(source) != source
    assert all((ROOT / "tests" / name.partition("::")[0]).is_file() for name in mutation.tests)


def test_there_are_twenty() -> None:
    assert len({one.name for one in MUTATIONS}) == 20
