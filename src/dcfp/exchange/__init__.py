"""Results for other programs: a script for OpenSees, a workbook for spreadsheets."""

from dcfp.exchange.opensees import opensees_script as opensees_script
from dcfp.exchange.opensees import plan_script as plan_script
from dcfp.exchange.workbook import write_workbook as write_workbook
