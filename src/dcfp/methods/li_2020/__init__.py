"""The three methods of Li et al. (2020), section 6: from a record's pulses, simplified, and from the PGV alone."""

# isort: off
from dcfp.methods.li_2020.constants import LI_2020 as LI_2020
from dcfp.methods.li_2020.constants import Constants as Constants
from dcfp.methods.li_2020.pulse_method import PULSE_METHOD as PULSE_METHOD
from dcfp.methods.li_2020.pulse_method import predict_from_pulses as predict_from_pulses
from dcfp.methods.li_2020.simplified_method import SIMPLIFIED_METHOD as SIMPLIFIED_METHOD
from dcfp.methods.li_2020.simplified_method import predict_simplified as predict_simplified
from dcfp.methods.li_2020.simplified_method import DESIGN_METHOD as DESIGN_METHOD
from dcfp.methods.li_2020.simplified_method import friction_that_holds as friction_that_holds
from dcfp.methods.li_2020.simplified_method import predict_from_pgv as predict_from_pgv
# isort: on
