"""The virtual test machine: test programs, runs, and what is measured on them."""

from dcfp.analysis.rig.codes import PROTOTYPE_TESTS as PROTOTYPE_TESTS
from dcfp.analysis.rig.loops import Loops as Loops
from dcfp.analysis.rig.measurement import Measurement as Measurement
from dcfp.analysis.rig.measurement import read_measurement as read_measurement
from dcfp.analysis.rig.measures import Cycle as Cycle
from dcfp.analysis.rig.plane_loops import Lap as Lap
from dcfp.analysis.rig.plane_loops import PlaneLoops as PlaneLoops
from dcfp.analysis.rig.plane_path import PATHS as PATHS
from dcfp.analysis.rig.plane_path import Circle as Circle
from dcfp.analysis.rig.plane_path import Cloverleaf as Cloverleaf
from dcfp.analysis.rig.plane_path import Ellipse as Ellipse
from dcfp.analysis.rig.plane_path import FigureOfEight as FigureOfEight
from dcfp.analysis.rig.plane_path import PlanePath as PlanePath
from dcfp.analysis.rig.plane_path import RecordedPath as RecordedPath
from dcfp.analysis.rig.plane_run import run_in_the_plane as run_in_the_plane
from dcfp.analysis.rig.program import Program as Program
from dcfp.analysis.rig.program import RigTest as RigTest
from dcfp.analysis.rig.program import VerticalLoad as VerticalLoad
from dcfp.analysis.rig.program import load_program as load_program
from dcfp.analysis.rig.run import run_program as run_program
from dcfp.analysis.rig.waveform import Recorded as Recorded
from dcfp.analysis.rig.waveform import Sine as Sine
from dcfp.analysis.rig.waveform import Triangle as Triangle
