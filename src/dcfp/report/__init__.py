"""A calculation report: one document, written as PDF or as a page of HTML."""

from dcfp.report.build import build_report as build_report
from dcfp.report.document import Document as Document
from dcfp.report.page import page_of as page_of
from dcfp.report.pdf import check_typst as check_typst
from dcfp.report.pdf import pdf_of as pdf_of
