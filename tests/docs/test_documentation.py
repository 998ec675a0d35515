"""What the pages say can be done: commands parse, Python runs, links lead somewhere, and nothing is left out.

The pages themselves are built by ``sphinx-build -W``, which runs every command and every script of the gallery; that takes minutes and is a step
of its own in ``.ci/run``.
"""

import ast
import re
import shlex
from pathlib import Path
from pkgutil import iter_modules

import numpy as np
import pytest

import dcfp
import dcfp.present
from dcfp.doors.cli.main import command_of, commands
from dcfp.errors import InputError
from dcfp.verify.check import tasks

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
BUILT = ("_build", "figures", "drawn")
PAGES = sorted(
    [ROOT / name for name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md")]
    + [path for path in DOCS.rglob("*.md") if path.relative_to(DOCS).parts[0] not in BUILT]
)

FENCE = re.compile(r"^```(?P<kind>[^\n]*)\n(?P<body>.*?)^```$", re.MULTILINE | re.DOTALL)
INLINE = re.compile(r"`([^`\n]+)`")
INDENTED = re.compile(r"^ {4}(dcfp .*)$", re.MULTILINE)
DIRECTIVE = re.compile(r"\{dcfp\} (.*)")
LINK = re.compile(r"\]\((?![a-z]+:)(?P<path>[^)#\s]*)(?:#(?P<place>[^)\s]*))?\)")


def name_of(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


def commands_of(text: str) -> list[str]:
    """Every command on a page: in blocks, indented, in a line, and in directives that run it."""
    found: list[str] = []
    for block in FENCE.finditer(text):
        directive = DIRECTIVE.fullmatch(block["kind"])
        if directive:
            body = [line for line in block["body"].splitlines() if line.strip() and not line.startswith(":")]
            found += [f"dcfp {line}" for line in (directive[1], *body)]
        elif block["kind"] in ("sh", ""):
            parts = re.split(r"&&|\n", block["body"])
            found += [part.strip().removeprefix(".venv/bin/") for part in parts]
    plain = FENCE.sub("", text)
    found += INDENTED.findall(plain) + INLINE.findall(plain)
    return [one for one in found if re.match(r"dcfp [a-z]", one)]


def refusal(command: str) -> str | None:
    """Why a command cannot be parsed; None where it can, or only names a command."""
    words = shlex.split(command, comments=True)[1:]
    if len(words) == 1:
        return None if words[0] in commands() else f"no command {words[0]!r}"
    try:
        found, words = command_of(words)
    except InputError as error:
        return str(error)
    if not words:
        return None
    parser = found.parser
    try:
        parser.parse_intermixed_args(words)
    except InputError as error:
        names_an_option = words[-1].startswith("--") and str(error) == f"{words[-1]} needs a value."
        return None if names_an_option else str(error)
    except SystemExit:  # --help
        return None
    return None


def heads_of(path: Path) -> set[str]:
    """What the headings of a page can be reached by, and the places that it names."""
    text = FENCE.sub("", path.read_text(encoding="utf-8"))
    heads = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    slugs = {re.sub(r"[^\w\- ]", "", head.lower()).replace(" ", "-") for head in heads}
    return slugs | set(re.findall(r"^\(([\w-]+)\)=$", text, re.MULTILINE))


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_command_is_one(page: Path) -> None:
    wrong = {one: refusal(one) for one in commands_of(page.read_text(encoding="utf-8"))}
    assert {one: why for one, why in wrong.items() if why} == {}


def test_wrong_commands_are_seen() -> None:
    text = "`dcfp respnd NCC`\n\n    dcfp respond NCC --pvg 0.5\n\n```sh\ndcfp study ida a.zarr --plott b.png\n```\n"
    assert [refusal(one) is None for one in commands_of(text)] == [False, False, False]
    assert refusal("dcfp respond NCC --pgv 0.5") is None


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_link_leads_somewhere(page: Path) -> None:
    places = {
        place
        for path in PAGES
        for place in re.findall(r"^\(([\w-]+)\)=$", path.read_text("utf-8"), re.MULTILINE)
    }
    lost: list[str] = []
    for link in LINK.finditer(FENCE.sub("", page.read_text(encoding="utf-8"))):
        target = (page.parent / link["path"]).resolve() if link["path"] else page
        if target.is_relative_to(DOCS / "figures"):  # made from the gallery
            made_from = DOCS / "gallery" / target.relative_to(DOCS / "figures")
            target = (
                made_from.with_name("GALLERY_HEADER.rst")
                if target.stem == "index"
                else made_from.with_suffix(".py")
            )
        if not target.exists() or (
            link["place"] and target.suffix == ".md" and link["place"] not in heads_of(target) | places
        ):
            lost.append(link[0])
    assert lost == []


PYTHON = [
    pytest.param(block["body"], id=f"{name_of(page)}-{number}")
    for page in PAGES
    for number, block in enumerate(FENCE.finditer(page.read_text(encoding="utf-8")))
    if block["kind"] == "python"
]


@pytest.mark.slow
@pytest.mark.parametrize("code", PYTHON)
def test_python_runs(code: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "page"}
    for statement in ast.parse(code).body:
        if not isinstance(statement, ast.Expr):
            exec(compile(ast.Module([statement], []), "page", "exec"), names)
            continue
        value = eval(compile(ast.Expression(statement.value), "page", "eval"), names)
        said = promised(code.splitlines(), statement.end_lineno or 0)
        if said:
            decimals = len(said[0].partition(".")[2])
            assert [f"{one:.{decimals}f}" for one in np.atleast_1d(value)] == said, ast.unparse(statement)


def promised(lines: list[str], end: int) -> list[str]:
    """The numbers that a comment behind or under a statement says of its value."""
    comment = lines[end - 1].partition("  # ")[2]
    if not comment and end < len(lines) and lines[end].startswith("# "):
        comment = lines[end].removeprefix("# ")
    numbers = re.match(r"-?\d+(?:\.\d+)?(?:, -?\d+(?:\.\d+)?)*", comment)
    return numbers[0].split(", ") if numbers else []


def test_every_command_has_its_page() -> None:
    for command in commands():
        text = (DOCS / "guide" / f"{command}.md").read_text(encoding="utf-8")
        assert f"(guide-{command})=\n# dcfp {command}\n" in text
        for part in [f"{command} {one}" for one in commands(command)] or [command]:
            assert f"```{{dcfp-options}} {part}\n" in text


def test_every_group_of_checks_is_in_the_validation() -> None:
    text = (DOCS / "validation.md").read_text(encoding="utf-8")
    for group in {task.group for task in tasks(full=True)}:
        assert f"## {group}\n" in text
        assert f"```{{dcfp-verification}} {group}\n" in text


def test_every_package_is_in_the_reference() -> None:
    inner = {"doors", "kernels", "present", "schema"}
    packages = {info.name for info in iter_modules(dcfp.__path__) if info.ispkg} - inner
    packages |= {f"present.{info.name}" for info in iter_modules(dcfp.present.__path__)}
    text = "".join(path.read_text(encoding="utf-8") for path in (DOCS / "reference").glob("*.md"))
    assert {name for name in packages if f"{{public-names}} dcfp.{name}\n" not in text} == set()


def test_figures_of_the_gallery_are_named_by_those_of_the_paper() -> None:
    for script in (DOCS / "gallery").glob("*.py"):
        numbers = re.fullmatch(r"plot_figure_((?:\d\d_)+)\w+", script.stem)
        assert numbers is not None
        title = script.read_text(encoding="utf-8").splitlines()[1]
        assert [int(one) for one in numbers[1].strip("_").split("_")] == [
            int(one) for one in re.findall(r"\d+", title)
        ]
