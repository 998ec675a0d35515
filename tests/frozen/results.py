"""Compare what the command line answers with the answers frozen earlier, number by number.

python tests/frozen/results.py             runs all commands of commands.py, names every difference and exits with 1
                                           if there is one (some minutes)
python tests/frozen/results.py --quick     only those that the tests run
python tests/frozen/results.py spectrum    only those that begin with these words
python tests/frozen/results.py --freeze    keeps what is answered now
"""

import argparse
import contextlib
import csv
import hashlib
import io
import json
import lzma
import math
import os
import re
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).parent))
    from commands import QUICK, SLOW, command_lines
    from inputs import write_inputs
else:
    from .commands import QUICK, SLOW, command_lines
    from .inputs import write_inputs

ROOT = Path(__file__).parents[2]
FROZEN = Path(__file__).with_name("results.json.xz")
#: Keys that differ from run to run, or from machine to machine.
VOLATILE = re.compile(
    r"elapsed|seconds_each|version|sha256|^threads$|^workers$|^created$|^rate$|^duration_of"
)
#: Keys of what only rounding leaves; they must stay below this [-].
ROUNDING = re.compile(r"energy_residual")
LARGEST_ROUNDING = 1e-9
#: Longest list of rows or cases that is kept as it is; of a longer one some, and of each column sum and digest.
LONGEST = 150
KEPT = 20


class Difference(NamedTuple):
    """What is not as it was."""

    path: str
    before: Any
    after: Any

    @property
    def relative(self) -> float:
        """Of two numbers their difference over the former [-], infinite for anything else."""
        if not all(_is_number(one) for one in (self.before, self.after)) or self.before == 0.0:
            return math.inf
        return abs(self.after - self.before) / abs(self.before)

    def within(self, tolerance: float) -> bool:
        """Whether it is nothing but two numbers so close [-], or the digest of such numbers."""
        return tolerance > 0.0 and (self.relative <= tolerance or self.path.endswith(".digest"))

    @property
    def is_wording(self) -> bool:
        """Whether only the words of a sentence differ."""
        return all(isinstance(one, str) and " " in one.strip() for one in (self.before, self.after))

    def __str__(self) -> str:
        size = f"  ({self.relative:.1e})" if math.isfinite(self.relative) else ""
        return f"{self.path}: {_short(self.before)} -> {_short(self.after)}{size}"


MISSING = "(not there)"


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("words", nargs="*", help="only commands that begin with these words")
    parser.add_argument("--quick", action="store_true", help="only those that the tests run")
    parser.add_argument("--freeze", action="store_true", help="keep what is answered now")
    parser.add_argument(
        "--tolerance", type=float, default=0.0, help="largest relative difference of a number; 0"
    )
    parser.add_argument("--words-too", action="store_true", help="a sentence put otherwise is a difference")
    parser.add_argument("--most", type=int, default=12, help="differences of a command that are shown; 12")
    parser.add_argument("--entry", default=entry_point(), help="function behind the command, MODULE:NAME")
    options = parser.parse_args()
    commands = [
        words
        for words in command_lines(QUICK) + ([] if options.quick else command_lines(SLOW))
        if words[: len(options.words)] == options.words or words[:2] == ["study", "run"]
    ]
    frozen = {} if options.freeze and not options.words else load()
    answers, count = {}, 0
    for line, answer, elapsed in answers_to(commands, options.entry):
        answers[line] = answer
        if options.freeze:
            print(f"{elapsed:6.1f} s  {answer['status']}  {line}", flush=True)
            continue
        found = [
            one
            for one in differences(frozen.get(line, MISSING), answer)
            if not one.within(options.tolerance) and (options.words_too or not one.is_wording)
        ]
        count += len(found)
        print(f"{elapsed:6.1f} s  {line}: {_summary(found)}", flush=True)
        for one in found[: options.most]:
            print(f"          {one}")
    if options.freeze:
        FROZEN.write_bytes(lzma.compress(json.dumps(frozen | answers, ensure_ascii=False).encode(), preset=9))
        print(f"{FROZEN}: {FROZEN.stat().st_size / 1024:.0f} KiB")
    else:
        print(f"{len(answers)} commands, {count} differences")
    return 1 if count else 0


def load() -> dict[str, Any]:
    """Return the frozen answers by their command lines."""
    return json.loads(lzma.decompress(FROZEN.read_bytes()))


def entry_point() -> str:
    """Return the function behind ``dcfp``, as pyproject.toml names it."""
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["scripts"]["dcfp"]


def answers_to(commands: list[list[str]], entry: str) -> Iterator[tuple[str, dict[str, Any], float]]:
    """Run commands one after the other in a folder of their own; yield the line, the answer and the time [s]."""
    module, _, name = entry.partition(":")
    run = getattr(import_module(module), name)
    here = Path.cwd()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_inputs(folder)
        os.chdir(folder)
        try:
            for words in commands:
                start = time.perf_counter()
                answer = _answer(run, words)
                yield " ".join(words), answer, time.perf_counter() - start
        finally:
            os.chdir(here)


def _answer(run: Any, words: list[str]) -> dict[str, Any]:
    """What a command prints as JSON, and the CSV file that it writes."""
    file = Path(words[words.index("--out") + 1]) if "--out" in words else None
    has_json = words[0] != "study" or words[1] != "export"
    buffers = [io.BytesIO(), io.BytesIO()]
    out, err = (io.TextIOWrapper(one, encoding="utf-8", write_through=True) for one in buffers)
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        status = run([*words, *(["--json"] if has_json else [])])
    printed, complaint = (one.getvalue().decode() for one in buffers)
    answer: dict[str, Any] = {"status": status}
    if status:
        answer["complaint"] = complaint
    elif has_json:
        answer["json"] = _reduced(json.loads(printed))
    if file is not None and file.suffix == ".csv":
        answer["csv"] = _rows(file)
    return answer


def _rows(file: Path) -> Any:
    """The rows of a CSV file by the names in its head."""
    with file.open(encoding="utf-8", newline="") as lines:
        return _reduced([{name: _cell(cell) for name, cell in row.items()} for row in csv.DictReader(lines)])


def _reduced(document: Any) -> Any:
    """Keep of every long list of rows some, and of each column the sum and a digest."""
    if isinstance(document, dict):
        return {key: _reduced(one) for key, one in document.items()}
    if not isinstance(document, list):
        return document
    if len(document) <= LONGEST or not all(isinstance(one, dict) for one in document):
        return [_reduced(one) for one in document]
    columns: dict[str, list[Any]] = {}
    for row in document:
        for path, value in _leaves(row):
            columns.setdefault(path, []).append(value)
    return {
        "count": len(document),
        "columns": {path: _column(values) for path, values in columns.items()},
        "rows": {str(i): document[i] for i in range(0, len(document), len(document) // KEPT)},
    }


def _leaves(document: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    if isinstance(document, dict):
        for key, one in document.items():
            if not VOLATILE.search(key) and not ROUNDING.search(key):
                yield from _leaves(one, f"{path}.{key}" if path else key)
    elif isinstance(document, list):
        for one in document:
            yield from _leaves(one, f"{path}[]")
    else:
        yield path, document


def _column(values: list[Any]) -> dict[str, Any]:
    numbers = [one for one in values if _is_number(one) and math.isfinite(one)]
    return {
        "numbers": len(numbers),
        "sum": math.fsum(numbers),
        "digest": hashlib.sha256(repr(values).encode()).hexdigest()[:12],
    }


def _cell(cell: str) -> float | str:
    try:
        return float(cell)
    except ValueError:
        return cell


def differences(before: Any, after: Any, path: str = "") -> Iterator[Difference]:
    """Name what differs between two documents; a key that is new is no difference."""
    if isinstance(before, dict) and isinstance(after, dict):
        for key, one in before.items():
            if not VOLATILE.search(key):
                yield from differences(one, after.get(key, MISSING), f"{path}.{key}" if path else key)
    elif isinstance(before, list) and isinstance(after, list):
        if len(before) != len(after):
            yield Difference(f"{path}.length", len(before), len(after))
        for index, (one, other) in enumerate(zip(before, after, strict=False)):
            yield from differences(one, other, f"{path}[{index}]")
    elif ROUNDING.search(path) and _is_number(after) and abs(after) < LARGEST_ROUNDING:
        return
    elif before != after and not (_is_nan(before) and _is_nan(after)):
        yield Difference(path, before, after)


def _is_number(one: Any) -> bool:
    return isinstance(one, int | float) and not isinstance(one, bool)


def _is_nan(one: Any) -> bool:
    return isinstance(one, float) and math.isnan(one)


def _summary(found: list[Difference]) -> str:
    if not found:
        return "as before"
    sizes = [one.relative for one in found if math.isfinite(one.relative)]
    return f"{len(found)} differences" + (f", numbers by up to {max(sizes):.1e}" if sizes else "")


def _short(one: Any) -> str:
    text = one if isinstance(one, str) else json.dumps(one, ensure_ascii=False)
    return text if len(text) <= 60 else f"{text[:57]}..."


if __name__ == "__main__":
    sys.exit(main())
