"""The findings and figures of Li et al. (2020), section 6, made again and put beside what the paper prints."""

from dcfp.verify.reproduction.analyses import Analyses as Analyses
from dcfp.verify.reproduction.analyses import analyse as analyse
from dcfp.verify.reproduction.findings import Finding as Finding
from dcfp.verify.reproduction.findings import findings_of as findings_of
