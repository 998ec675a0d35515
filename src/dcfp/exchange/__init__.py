"""Results for other programs: scripts for OpenSees, link properties for SAP2000 and ETABS, a workbook for spreadsheets."""

from dcfp.exchange.opensees import opensees_script as opensees_script
from dcfp.exchange.opensees import plan_script as plan_script
from dcfp.exchange.sap2000 import link_table as link_table
from dcfp.exchange.sap2000 import sap2000_text as sap2000_text
from dcfp.exchange.workbook import write_workbook as write_workbook
