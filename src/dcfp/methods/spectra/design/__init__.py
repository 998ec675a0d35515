"""Design spectra of codes."""

from dcfp.methods.spectra.design.asce_2016 import Asce2016Spectrum as Asce2016Spectrum
from dcfp.methods.spectra.design.eurocode_8 import Eurocode8Spectrum as Eurocode8Spectrum
from dcfp.methods.spectra.design.notification_2000 import Notification2000Spectrum as Notification2000Spectrum
