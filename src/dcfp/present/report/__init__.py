"""A calculation report: one document, written as PDF or as a page of HTML."""

from dcfp.present.report.build import build_report as build_report
from dcfp.present.report.document import Document as Document
from dcfp.present.report.forms import check_typst as check_typst
from dcfp.present.report.forms import page_of as page_of
from dcfp.present.report.forms import pdf_of as pdf_of
