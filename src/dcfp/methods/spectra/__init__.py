"""Elastic response and input energy spectra of records, and spectra from files; those of codes are with their codes."""

from dcfp.methods.spectra.elastic import ElasticSpectrum as ElasticSpectrum
from dcfp.methods.spectra.elastic import TabulatedSpectrum as TabulatedSpectrum
from dcfp.methods.spectra.of_record import EnergySpectrum as EnergySpectrum
from dcfp.methods.spectra.of_record import ResponseSpectrum as ResponseSpectrum
from dcfp.methods.spectra.of_record import input_energy_spectrum as input_energy_spectrum
from dcfp.methods.spectra.of_record import response_spectrum as response_spectrum
from dcfp.methods.spectra.of_station import StationSpectrum as StationSpectrum
from dcfp.methods.spectra.of_station import station_spectrum as station_spectrum
