"""The web page: response, test machine and design chart, served to a browser on this machine."""

import argparse
import sys

from dcfp.doors.cli.parser import Parser, whole_number
from dcfp.errors import InputError


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument(
        "--host",
        default="127.0.0.1",
        metavar="ADDRESS",
        help="address to serve at; by default 127.0.0.1, which only this machine can reach",
    )
    parser.add_argument(
        "--port", type=whole_number(1, 65535), default=8080, metavar="N", help="port; by default 8080"
    )
    parser.add_argument("--no-browser", action="store_true", help="do not open a browser")


def run(chosen: argparse.Namespace) -> int:
    """Serve the page until the process is interrupted."""
    try:
        # late, so that a slip in the command is answered at once
        from dcfp.doors.app.serve import check_address, is_local, serve
    except ModuleNotFoundError as error:
        if error.name != "nicegui":
            raise
        msg = "the web page needs the package nicegui, which is not installed: pip install 'dcfp[app]' brings it."
        raise InputError(msg) from error
    check_address(chosen.host, chosen.port)
    if not is_local(chosen.host):
        print(
            f"dcfp: anyone who can reach port {chosen.port} of this machine can use the page; it asks for no password.",
            file=sys.stderr,
        )
    print(f"dcfp: http://{_shown(chosen.host)}:{chosen.port} (Ctrl+C ends it)", file=sys.stderr, flush=True)
    serve(chosen.host, chosen.port, show=not chosen.no_browser)
    return 0


def _shown(host: str) -> str:
    """Return a host as it stands in an address."""
    return f"[{host}]" if ":" in host else host
