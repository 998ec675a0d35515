"""Elastic response and input energy spectra of records, and the design spectra of codes."""

from dcfp.spectrum.elastic import ElasticSpectrum as ElasticSpectrum
from dcfp.spectrum.elastic import TabulatedSpectrum as TabulatedSpectrum
from dcfp.spectrum.input_energy import EnergySpectrum as EnergySpectrum
from dcfp.spectrum.input_energy import input_energy_spectrum as input_energy_spectrum
from dcfp.spectrum.of_record import ResponseSpectrum as ResponseSpectrum
from dcfp.spectrum.of_record import response_spectrum as response_spectrum
