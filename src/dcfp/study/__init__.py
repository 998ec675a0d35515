"""Studies: from one analysis to a million, over any factors, into a store that survives an interruption.

Each name is imported when it is first used, so that to read a store does not wait for all that makes one.
"""

from typing import Any

import lazy_loader

_loader: Any = lazy_loader
__getattr__, __dir__, __all__ = _loader.attach_stub(__name__, __file__)
