"""A calculation as a workbook for spreadsheets."""

from dcfp.exchange.excel.write import write_workbook as write_workbook
