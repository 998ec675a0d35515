"""``dcfp app``: the web page, served to a browser."""

import argparse
import sys

from dcfp.errors import InputError


def run(chosen: argparse.Namespace) -> None:
    """Serve the page until the process is interrupted."""
    try:
        from dcfp.doors.app.serve import check_address, is_local, serve  # late: it may not be installed
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
    host = f"[{chosen.host}]" if ":" in chosen.host else chosen.host
    print(f"dcfp: http://{host}:{chosen.port} (Ctrl+C ends it)", file=sys.stderr, flush=True)
    serve(chosen.host, chosen.port, show=not chosen.no_browser)
