"""Ground motions: read, named, made, treated and measured."""

from dcfp.motion.ground_motion import GroundMotion as GroundMotion
from dcfp.motion.ground_motion import Origin as Origin
from dcfp.motion.load import load_motion as load_motion
from dcfp.motion.load import load_station as load_station
from dcfp.motion.load import read_motion as read_motion
from dcfp.motion.load import read_motions as read_motions
from dcfp.motion.measures import baseline_warning as baseline_warning
from dcfp.motion.measures import measure as measure
from dcfp.motion.named import NamedRecord as NamedRecord
from dcfp.motion.named import named_motion as named_motion
from dcfp.motion.named import named_records as named_records
from dcfp.motion.station import Station as Station
from dcfp.motion.station_measures import PrincipalAxes as PrincipalAxes
from dcfp.motion.station_measures import principal_axes as principal_axes
