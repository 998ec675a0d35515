"""How sure estimates are, whatever the errors of neighbouring samples have in common."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from dcfp.arrays import FloatArray

#: Probability that an interval contains the truth.
CONFIDENCE = 0.95
#: Condition of scaled normal equations above which they determine nothing.
_LARGEST_CONDITION = 1e12


@dataclass(frozen=True, eq=False)
class Jackknife:
    """Spread of least squares estimates.

    Attributes
    ----------
    covariance
        Of the estimates, shape (parameters, parameters); infinite where a block alone determines one.
    freedom
        Degrees of freedom of each variance, shape (parameters,).
    blocks
        Number of blocks.
    lost
        Number of the parameter that cannot be told from the others, where there is one.
    """

    covariance: FloatArray
    freedom: FloatArray
    blocks: int
    lost: int | None = None

    @property
    def standard_error(self) -> FloatArray:
        """Standard errors of the estimates."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def half_width(self) -> FloatArray:
        """Half of the length of the 95 % intervals."""
        return np.asarray(student.ppf(0.5 + 0.5 * CONFIDENCE, self.freedom)) * self.standard_error

    @property
    def correlation(self) -> FloatArray:
        """Correlation of the estimates."""
        error = self.standard_error
        with np.errstate(invalid="ignore"):
            return np.clip(self.covariance / np.outer(error, error), -1.0, 1.0)


def jackknife(slopes: FloatArray, residual: FloatArray, block: NDArray[np.int64]) -> Jackknife:
    r"""Return the covariance of least squares estimates by leaving out one block of samples after another.

    .. math:: \mathrm{Cov} = \frac{G - 1}{G} \sum_g d_g d_g^T, \quad d_g = (J^T J - J_g^T J_g)^{-1} J_g^T r_g

    Parameters
    ----------
    slopes, residual
        J and r at the solution, weighted, shapes (n, parameters) and (n,).
    block
        Number of the block of each sample, from zero without gaps, shape (n,).

    Notes
    -----
    :math:`d_g` is the change of the estimates when block g is left out, to first order. Within a block errors may depend on each
    other and differ in size as they like; from block to block they must not. This is the estimator CR3 for clustered errors (Bell and McCaffrey 2002), which
    is not too small in the mean where blocks weigh unequally. The degrees of freedom for Student's t follow from the part :math:`\tau_g^2` that each block has in the variance if
    all errors are alike, :math:`\nu = (\sum \tau_g^2)^2 / \sum \tau_g^4` (Satterthwaite).
    """
    blocks, count = int(block.max()) + 1, int(slopes.shape[1])
    size = np.sqrt((slopes**2).sum(axis=0))
    size[size == 0.0] = 1.0
    order = np.argsort(block, kind="stable")
    bounds = np.searchsorted(block[order], np.arange(blocks))
    scaled = slopes[order] / size
    parts: list[FloatArray] = [part.T @ part for part in np.split(scaled, bounds[1:])]
    own: FloatArray = np.array(parts)
    pull: FloatArray = np.add.reduceat(scaled * residual[order, None], bounds, axis=0)
    whole: FloatArray = own.sum(axis=0)
    left: FloatArray = whole - own
    weakest = int(np.argmax(np.linalg.cond(left)))
    if not np.linalg.cond(left[weakest]) < _LARGEST_CONDITION:
        lost = _least_told(left[weakest])
        unknown: FloatArray = np.full((count, count), np.inf)
        freedom: FloatArray = np.full(count, 1.0)
        return Jackknife(unknown, freedom, blocks, lost)
    change = np.asarray(np.linalg.solve(left, pull[:, :, None])[:, :, 0], dtype=np.float64)
    covariance: FloatArray = (blocks - 1) / blocks * change.T @ change
    inverse = np.asarray(np.linalg.inv(whole), dtype=np.float64)
    share: FloatArray = np.einsum("ij,gjk,ki->gi", inverse, own, inverse)
    freedom = np.asarray(share.sum(axis=0) ** 2 / (share**2).sum(axis=0))
    return Jackknife(covariance / np.outer(size, size), freedom, blocks)


def _least_told(equations: FloatArray) -> int:
    """Return the number of the parameter that normal equations tell least of; of several the last."""
    direction: FloatArray = np.abs(np.linalg.eigh(equations)[1][:, 0])
    return int(np.flatnonzero(direction > 0.9 * direction.max())[-1])
