"""Pages that are files of the repository, and links that lead out of this folder."""

import posixpath
import re
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

ROOT = Path(__file__).parents[2]
#: Pages of which only a stub is in this folder, and the file that they show.
FROM_ROOT = {"readme": "README.md", "changelog": "CHANGELOG.md", "contributing": "CONTRIBUTING.md"}
_PAGES = {name: page for page, name in FROM_ROOT.items()}
_LINK = re.compile(r"\]\((?![a-z]+:|#)(?P<path>[^)#\s]+)(?P<place>#[^)\s]*)?\)")


def read(app: Sphinx, docname: str, content: list[str]) -> None:
    """Take the page from the repository where it is a stub, and turn links so that they work in here."""
    if docname.startswith("figures/"):
        return
    origin = f"docs/{docname}.md"
    if docname in FROM_ROOT:
        origin = FROM_ROOT[docname]
        app.env.note_dependency(str(ROOT / origin))
        content[0] = (ROOT / origin).read_text(encoding="utf-8")

    def turned(link: re.Match[str]) -> str:
        target = posixpath.normpath(posixpath.join(posixpath.dirname(origin), link["path"]))
        if target in _PAGES:
            target = f"docs/{_PAGES[target]}.md"
        elif target == "docs/decisions":
            target = "docs/decisions/index.md"
        path = posixpath.relpath(target, posixpath.join("docs", posixpath.dirname(docname)))
        return f"]({path}{link['place'] or ''})"

    content[0] = _LINK.sub(turned, content[0])


def setup(app: Sphinx) -> dict[str, Any]:
    """Register with Sphinx."""
    app.connect("source-read", read)
    return {"version": "1", "parallel_read_safe": True, "parallel_write_safe": True}
