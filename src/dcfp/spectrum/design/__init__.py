"""Design spectra of codes."""

from dcfp.spectrum.design.asce_2016 import Asce2016Spectrum as Asce2016Spectrum
from dcfp.spectrum.design.eurocode_8 import Eurocode8Spectrum as Eurocode8Spectrum
from dcfp.spectrum.design.notification_2000 import Notification2000Spectrum as Notification2000Spectrum
