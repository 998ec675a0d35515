"""Elastic response and input energy spectra of records, and the design spectra of codes."""

from dcfp.methods.spectra.elastic import ElasticSpectrum as ElasticSpectrum
from dcfp.methods.spectra.elastic import TabulatedSpectrum as TabulatedSpectrum
from dcfp.methods.spectra.input_energy import EnergySpectrum as EnergySpectrum
from dcfp.methods.spectra.input_energy import input_energy_spectrum as input_energy_spectrum
from dcfp.methods.spectra.of_record import ResponseSpectrum as ResponseSpectrum
from dcfp.methods.spectra.of_record import response_spectrum as response_spectrum
