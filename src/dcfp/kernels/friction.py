r"""The coefficient of friction as compiled code sees it.

All but one of the package's laws are a reference value, which holds the effect of pressure, times

.. math:: (1 - a\,e^{-b |v|})\,(A\,e^{-B T} + C)

The other one falls with the cycling parameter instead of the temperature. Both forms are in line; that of any other law is the address of a compiled function,
which is called, so that one compiled kernel serves every law.
"""

import ctypes
from typing import Any, NamedTuple

from llvmlite import ir
from numba.core import cgutils
from numba.extending import intrinsic

from dcfp.kernels._jit import kernel, numba_config
from dcfp.kernels.heat_state import CYCLING_PARAMETER, Heat
from dcfp.kernels.law import CYCLING, LAW_ARGUMENTS, Law
from dcfp.kernels.motion import SystemConstants, speed_factor
from dcfp.kernels.sum_of_exponentials import exp_neg

# numba gives these no types
utilities: Any = cgutils


class BearingModel(NamedTuple):
    """A bearing under its load, with its friction and the heat in its plates."""

    law: Law
    system: SystemConstants
    heat: Heat


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
    speed_term = 1.0 - law.speed_drop * exp_neg(law.speed_rate * speed)
    if law.form == CYCLING:
        return law.reference * speed_term * exp_neg((law.heat_rate * cycling) ** law.heat_scale)
    heat_term = law.heat_scale * exp_neg(law.heat_rate * temperature) + law.heat_floor
    return law.reference * speed_term * heat_term


@kernel
def with_reference(law: Law, reference: float) -> Law:
    """Return a law in line at another pressure, at which its reference is this one [-]."""
    return Law(
        law.form, reference, law.speed_drop, law.speed_rate, law.heat_scale, law.heat_rate, law.heat_floor
    )


@kernel
def _plate_coefficient(model: BearingModel, plate: int, speed: float, first: int) -> float:
    system, workspace = model.system, model.heat.workspace
    temperature, cycling = workspace[first + plate], workspace[first + plate + CYCLING_PARAMETER]
    return coefficient(model.law, system.pressure, speed_factor(system, plate) * speed, temperature, cycling)


@kernel
def mean_coefficient(model: BearingModel, speed: float, first: int) -> float:
    """Coefficient of the whole bearing [-] at a relative speed [mm/s]: the plates' mean by their share of the travel.

    The plates' temperatures [degC] stand in the workspace from entry `first` on, their cycling parameters so many entries later.
    """
    one = _plate_coefficient(model, 0, speed, first)
    if model.system.plates == 1:
        return one
    other = _plate_coefficient(model, 1, speed, first)
    return model.system.first_share * one + model.system.second_share * other


@kernel
def store_ratios(model: BearingModel, speed: float, first: int, ratio: int) -> None:
    """Store from entry `ratio` on the coefficient of each plate over that of the bearing, if the plates differ."""
    if model.system.plates == 1:
        return
    one, other = _plate_coefficient(model, 0, speed, first), _plate_coefficient(model, 1, speed, first)
    mean = model.system.first_share * one + model.system.second_share * other
    model.heat.workspace[ratio] = one / mean
    model.heat.workspace[ratio + 1] = other / mean
