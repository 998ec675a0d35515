"""Many response history analyses in one compiled call: peaks and energies, without histories."""

from dcfp.analysis.batch.lanes import GroundSet as GroundSet
from dcfp.analysis.batch.lanes import Lanes as Lanes
from dcfp.analysis.batch.respond import Peaks as Peaks
from dcfp.analysis.batch.respond import available_threads as available_threads
from dcfp.analysis.batch.respond import respond_in_batch as respond_in_batch
