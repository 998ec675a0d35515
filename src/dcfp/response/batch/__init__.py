"""Many response history analyses in one compiled call: peaks and energies, without histories."""

from dcfp.response.batch.ground import GroundSet as GroundSet
from dcfp.response.batch.lanes import Lanes as Lanes
from dcfp.response.batch.peaks import Peaks as Peaks
from dcfp.response.batch.respond import available_threads as available_threads
from dcfp.response.batch.respond import respond_in_batch as respond_in_batch
