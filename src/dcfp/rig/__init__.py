"""The virtual test machine: test programs, runs, and what is measured on them."""

from dcfp.rig.load import VerticalLoad as VerticalLoad
from dcfp.rig.loops import Loops as Loops
from dcfp.rig.measurement import Measurement as Measurement
from dcfp.rig.measurement import read_measurement as read_measurement
from dcfp.rig.measures import Cycle as Cycle
from dcfp.rig.program import Program as Program
from dcfp.rig.program import RigTest as RigTest
from dcfp.rig.read import load_program as load_program
from dcfp.rig.run import run_program as run_program
from dcfp.rig.waveform import Recorded as Recorded
from dcfp.rig.waveform import Sine as Sine
from dcfp.rig.waveform import Triangle as Triangle
