"""The line of every value of a TOML file."""

import tomllib
from collections.abc import Iterator

from dcfp.schema.toml_places import Place, Way, lines_of

TEXT = '''# a comment with [brackets] and "quotes"
name = "a = [1, 2] # no comment"
long = """
two
lines"""
"quoted key".below = 3

[plan]  # a table
grid = { x = [0, 6,
  12], "type" = 'A' }
bearings = [
  { x = 1, y = 2 },  # first
  { x = 3, y = 4 },

  { x = 5, y = 6 },
]
[[storey]]
mass = 1_000
[storey.more]
height = 3.5
[[storey]]
mass = 2_000
date = 1979-05-27T07:32:00Z
[bearing.A]
radius = "4.5 m"
'''


def ways(value: object, way: Way = ()) -> Iterator[Way]:
    if way:
        yield way
    parts = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, one in parts:
        yield from ways(one, (*way, key))


def test_every_value_has_the_line_on_which_it_stands() -> None:
    found = lines_of(TEXT)
    content = tomllib.loads(TEXT)
    # what a dotted head or a list of tables makes on the way has no line of its own
    missing = set(ways(content)) - found.keys()
    assert missing == {("storey",), ("bearing",)}
    lines = TEXT.splitlines()
    for way, words in {
        ("name",): "name =",
        ("long",): "long =",
        ("quoted key", "below"): '"quoted key"',
        ("plan",): "[plan]",
        ("plan", "grid", "x", 2): "12]",
        ("plan", "grid", "type"): "'A'",
        ("plan", "bearings", 0, "y"): "first",
        ("plan", "bearings", 2, "x"): "x = 5",
        ("storey", 0): "[[storey]]",
        ("storey", 0, "more", "height"): "height = 3.5",
        ("storey", 1, "mass"): "mass = 2_000",
        ("storey", 1, "date"): "date",
        ("bearing", "A", "radius"): "radius",
    }.items():
        assert words in lines[found[way] - 1], way


def test_a_place_that_is_not_in_the_file_is_that_of_its_table() -> None:
    whole = Place("a.toml", lines_of(TEXT))
    assert whole.of("plan", label="[plan]").of("spring") == "a.toml, line 8: [plan]"
    assert whole.of("bearing", "A", label="[bearing.A]").below == ["radius"]
    assert whole.of("nothing") == "a.toml"


def test_windows_line_ends_count_once() -> None:
    assert lines_of(TEXT.replace("\n", "\r\n")) == lines_of(TEXT)
