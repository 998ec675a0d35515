"""Elastic response and input energy spectra of records, and the design spectra of codes."""

from dcfp.methods.spectra.asce_2016 import Asce2016Spectrum as Asce2016Spectrum
from dcfp.methods.spectra.elastic import ElasticSpectrum as ElasticSpectrum
from dcfp.methods.spectra.elastic import TabulatedSpectrum as TabulatedSpectrum
from dcfp.methods.spectra.eurocode_8 import Eurocode8Spectrum as Eurocode8Spectrum
from dcfp.methods.spectra.notification_2000 import Notification2000Spectrum as Notification2000Spectrum
from dcfp.methods.spectra.of_record import EnergySpectrum as EnergySpectrum
from dcfp.methods.spectra.of_record import ResponseSpectrum as ResponseSpectrum
from dcfp.methods.spectra.of_record import input_energy_spectrum as input_energy_spectrum
from dcfp.methods.spectra.of_record import response_spectrum as response_spectrum
