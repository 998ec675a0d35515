"""Formats of record files: each module registers its own, and what they have in common."""

from dcfp.motion.formats import cosmos as cosmos
from dcfp.motion.formats import csmip as csmip
from dcfp.motion.formats import cwb as cwb
from dcfp.motion.formats import esm as esm
from dcfp.motion.formats import jma as jma
from dcfp.motion.formats import kyoshin as kyoshin
from dcfp.motion.formats import peer as peer
from dcfp.motion.formats import plain as plain
