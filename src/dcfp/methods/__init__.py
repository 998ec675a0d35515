"""Displacement and energy of the isolation layer without a response history analysis: predictions, codes, spectra.

Every method is one module, named after the paper or the code, which registers it with all that its users need; they are in the order of tables here.
"""

# isort: off
from dcfp.methods.pulses import NOTHING as NOTHING
from dcfp.methods.pulses import Prediction as Prediction
from dcfp.methods.pulses import PulsePrediction as PulsePrediction
from dcfp.methods.pulses import Pulses as Pulses
from dcfp.methods.pulses import find_pulses as find_pulses
from dcfp.methods.nodes import Nodes as Nodes
from dcfp.methods.nodes import find_nodes as find_nodes
from dcfp.methods.li_2020 import DESIGN_METHOD as DESIGN_METHOD
from dcfp.methods.li_2020 import PULSE_METHOD as PULSE_METHOD
from dcfp.methods.li_2020 import SIMPLIFIED_METHOD as SIMPLIFIED_METHOD
from dcfp.methods.plane_march import PlaneMarch as PlaneMarch
from dcfp.methods.plane_march import march_in_plane as march_in_plane
from dcfp.methods.pgv_and_spectrum import DESIGN_WITH_SPECTRUM as DESIGN_WITH_SPECTRUM
from dcfp.methods.pgv_and_spectrum import predict_with_spectrum as predict_with_spectrum
from dcfp.methods.pulse_march import PULSE_MARCH as PULSE_MARCH
from dcfp.methods.pulse_march import PulseMarch as PulseMarch
from dcfp.methods.pulse_march import march_through_pulses as march_through_pulses
from dcfp.methods.asce_2016 import ASCE_2016 as ASCE_2016
from dcfp.methods.eurocode_8 import EUROCODE_8 as EUROCODE_8
from dcfp.methods.aij_2016 import AIJ_1 as AIJ_1
from dcfp.methods.aij_2016 import AIJ_2 as AIJ_2
from dcfp.methods.aij_2016 import AIJ_ENERGY as AIJ_ENERGY
from dcfp.methods.iwan_1980 import IWAN_1980 as IWAN_1980
# isort: on

from dcfp.methods.method import METHODS as METHODS
