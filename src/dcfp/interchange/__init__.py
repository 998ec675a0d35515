"""Results for other programs: a script for OpenSees, a workbook for spreadsheets."""

from dcfp.interchange.excel import write_workbook as write_workbook
from dcfp.interchange.opensees import opensees_script as opensees_script
