"""The figure of an identification: a panel for each test, the factors with what was fitted, and the residuals."""

import re

import numpy as np
import pytest

from dcfp.inference.identification import identify
from dcfp.present.figures import save_figure
from dcfp.present.figures.identification import plot_identification


def texts(figure) -> list[str]:
    return [text.get_text() for text in figure.findobj(lambda artist: hasattr(artist, "get_text"))]


@pytest.mark.slow
def test_every_test_has_its_panel(dependency, noisy, tmp_path) -> None:
    fitted, held = ("V20", "V50", "V400", "P40"), ("V150", "P80")
    random = np.random.default_rng(1)
    found = identify(
        [noisy(dependency[name], random) for name in fitted],
        held_out=[noisy(dependency[name], random) for name in held],
    )
    figure = plot_identification(found)
    path = tmp_path / "figure.svg"
    save_figure(figure, path)
    words = texts(figure)
    for name in fitted:
        assert any(text.startswith(f"{name}: ") for text in words)
    for name in held:
        assert any(text.startswith(f"{name} (held out): ") for text in words)
    assert "not fitted" not in words
    assert path.stat().st_size > 10_000


@pytest.mark.slow
def test_the_same_identification_gives_the_same_figure(dependency, noisy, tmp_path) -> None:
    # with noise: without it the residuals are the rounding of a fit, which memory's layout can change
    random = np.random.default_rng(2)
    tests = [noisy(dependency["V20"], random)]
    paths = [tmp_path / f"{n}.svg" for n in range(2)]
    for path in paths:
        figure = plot_identification(identify(tests))
        words = texts(figure)
        assert any(text.startswith("V20: ") for text in words)
        assert "not fitted" in words  # one test does not tell of the pressure
        save_figure(figure, path)
    # names of clipping paths are hashes of positions, whose last digits the solver of the layout leaves open
    first, second = (re.sub(r"p[0-9a-f]{10}\b", "p", path.read_text()) for path in paths)
    assert first == second
