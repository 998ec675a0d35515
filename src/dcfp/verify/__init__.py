"""What is checked against what, and by how much it differs: `dcfp verify` and the tests run the same checks."""

from dcfp.verify.check import CHECKS as CHECKS
from dcfp.verify.check import run_checks as run_checks
