"""Response history analysis and its energy balance; each name is imported when it is first used."""

from typing import Any

import lazy_loader

_loader: Any = lazy_loader
__getattr__, __dir__, __all__ = _loader.attach_stub(__name__, __file__)
