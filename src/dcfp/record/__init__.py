"""Ground motions: read, named, made, treated and measured."""

from dcfp.record.ground_motion import GroundMotion as GroundMotion
from dcfp.record.ground_motion import Origin as Origin
from dcfp.record.load import load_motion as load_motion
from dcfp.record.measures import Measures as Measures
from dcfp.record.measures import baseline_warning as baseline_warning
from dcfp.record.measures import measure as measure
from dcfp.record.named import NamedRecord as NamedRecord
from dcfp.record.named import named_motion as named_motion
from dcfp.record.named import named_records as named_records
from dcfp.record.read import read_motion as read_motion
from dcfp.record.read import read_motions as read_motions
