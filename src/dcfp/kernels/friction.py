r"""The coefficient of friction as compiled code sees it.

A law is a `Law`, whatever it is: numbers, among which is the form that they are the constants of. All but one of the package's
laws are a reference value times

.. math:: (1 - a\,e^{-b |v|})\,(A\,e^{-B T} + C)

in which the reference holds the effect of pressure; the other one falls with the cycling parameter instead of the temperature. Both forms
are in line. The form of any other law is the address of a compiled function, which is called, so that one compiled kernel serves every law.
"""

import ctypes
from typing import Any

import numpy as np
from llvmlite import ir
from numba.core import cgutils
from numba.extending import intrinsic
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel, numba_config
from dcfp.kernels.exponential import fading
from dcfp.kernels.heat_state import DOSE
from dcfp.kernels.law import CYCLING, LAW_ARGUMENTS, Law
from dcfp.kernels.motion import Structure

# numba gives these no types
utilities: Any = cgutils


def _called_interpreted(law: Law, pressure: float, speed: float, temperature: float, cycling: float) -> float:
    function = ctypes.CFUNCTYPE(ctypes.c_double, *LAW_ARGUMENTS)(law.form)
    return function((ctypes.c_double * 6)(*law[1:]), pressure, speed, temperature, cycling)


def _called_compiled(typing: Any, law: Any, pressure: Any, speed: Any, temperature: Any, cycling: Any) -> Any:
    def build(context: Any, builder: Any, signature: Any, values: Any) -> Any:
        address, *constants = utilities.unpack_tuple(builder, values[0])
        double = ir.DoubleType()
        place = utilities.alloca_once(builder, ir.ArrayType(double, len(constants)))
        for i, constant in enumerate(constants):
            builder.store(constant, utilities.gep_inbounds(builder, place, 0, i))
        kind = ir.FunctionType(double, (double.as_pointer(), double, double, double, double))
        function = builder.inttoptr(address, kind.as_pointer())
        return builder.call(function, (builder.bitcast(place, double.as_pointer()), *values[1:]))

    return pressure(law, pressure, speed, temperature, cycling), build


call_by_address: Any = _called_interpreted if numba_config.DISABLE_JIT else intrinsic(_called_compiled)


@kernel
def coefficient(law: Law, pressure: float, speed: float, temperature: float, cycling: float) -> float:
    """Coefficient of friction [-] at a pressure [N/mm2], speed [mm/s], temperature [degC] and cycling parameter [N/s]."""
    if law.form > CYCLING:
        return call_by_address(law, pressure, speed, temperature, cycling)
    speed_factor = 1.0 - law.speed_drop * fading(law.speed_rate * speed)
    if law.form == CYCLING:
        return law.reference * speed_factor * fading((law.heat_rate * cycling) ** law.heat_scale)
    heat_factor = law.heat_scale * fading(law.heat_rate * temperature) + law.heat_floor
    return law.reference * speed_factor * heat_factor


@kernel
def with_reference(law: Law, reference: float) -> Law:
    """Return a law in line at another pressure, at which its reference is this one [-]."""
    return Law(
        law.form,
        reference,
        law.speed_drop,
        law.speed_rate,
        law.heat_scale,
        law.heat_rate,
        law.heat_floor,
    )


@kernel
def mean_coefficient(
    law: Law, structure: Structure, speed: float, notes: NDArray[np.float64], first: int
) -> float:
    """Coefficient of the whole bearing [-] at a relative speed [mm/s]: the plates' mean by their share of the travel.

    The plates' temperatures [degC] stand in `notes` from entry `first` on, their doses so many entries later.
    """
    one = coefficient(
        law, structure.pressure, structure.first_speed * speed, notes[first], notes[first + DOSE]
    )
    if structure.plates == 1:
        return one
    other = coefficient(
        law, structure.pressure, structure.second_speed * speed, notes[first + 1], notes[first + DOSE + 1]
    )
    return structure.first_share * one + structure.second_share * other


@kernel
def note_ratios(
    law: Law, structure: Structure, speed: float, notes: NDArray[np.float64], first: int, ratio: int
) -> None:
    """Note from entry `ratio` on the coefficient of each plate over that of the bearing, if the plates differ."""
    if structure.plates == 1:
        return
    one = coefficient(
        law, structure.pressure, structure.first_speed * speed, notes[first], notes[first + DOSE]
    )
    other = coefficient(
        law, structure.pressure, structure.second_speed * speed, notes[first + 1], notes[first + DOSE + 1]
    )
    mean = structure.first_share * one + structure.second_share * other
    notes[ratio] = one / mean
    notes[ratio + 1] = other / mean
