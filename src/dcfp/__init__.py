"""Double concave friction pendulum bearings under recorded earthquakes.

What is public stands in ``__init__.pyi``, in the order in which data flow: a motion, a bearing, its response; a test program, its results; pulses, a prediction, a comparison; a study of many. Each name
is imported when it is first used, so that ``dcfp --help`` does not wait for the compiler of the kernels.
"""

from typing import Any

import lazy_loader

_loader: Any = lazy_loader
__getattr__, __dir__, __all__ = _loader.attach_stub(__name__, __file__)
