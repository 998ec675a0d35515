"""The fields of the bearing, its friction and its heat."""

from collections.abc import Callable
from typing import Any

from nicegui import ui

from dcfp.doors.app.fields import action, card, choice_field, more, number_field
from dcfp.doors.app.forms import HEATINGS, LAWS, LIMITS, BearingForm, reference_of

_NUMBERS = (
    ("lower_radius", "Radius, lower plate", "mm", ""),
    ("upper_radius", "Radius, upper plate", "mm", ""),
    ("slider", "Slider diameter", "mm", ""),
    ("pressure", "Pressure", "N/mm²", ""),
    ("stiffness", "Stiffness at rest", "kN/mm", ""),
    ("capacity", "Capacity", "mm", "not known"),
)


class BearingPanel:
    """The fields; every page of a visitor has them, and they always show the same bearing.

    Parameters
    ----------
    form
        What the fields hold.
    changed
        Called when one of them has changed.
    varies
        Names of fields that this page varies itself.
    """

    def __init__(self, form: BearingForm, changed: Callable[[], None], varies: tuple[str, ...] = ()) -> None:
        self._form, self._changed = form, changed
        self._fields: dict[str, Any] = {}
        self._quiet = False
        numbers = [one for one in _NUMBERS if one[0] not in varies]
        with card("Bearing"):
            for first, second in zip(numbers[::2], numbers[1::2], strict=False):
                with ui.element("div").classes("pair"):
                    self._number(*first)
                    self._number(*second)
            if len(numbers) % 2:
                self._number(*numbers[-1])
        with card("Friction and heat"):
            self._fields["law"] = choice_field("Friction law", LAWS, form.law, self._choose_law)
            with ui.element("div").classes("pair"):
                if "mu" not in varies:
                    self._number("mu", "Reference µ", "–", "")
                self._number("ambient", "Ambient", "°C", "")
            self._fields["heating"] = choice_field(
                "Temperature of the contact from", HEATINGS, form.heating, self._choose_heating
            )
            with more("Plates"):
                self._number("thickness", "Thickness of the plates", "mm", "endless")
            action("Bearing of the paper", self._reset)

    def refresh(self) -> None:
        """Show what the form holds, which another page may have changed."""
        self._quiet = True
        for name, element in self._fields.items():
            element.value = getattr(self._form, name)
        self._quiet = False

    def _number(self, name: str, label: str, unit: str, hint: str) -> None:
        def change(value: float | None) -> None:
            self._set(name, value)

        self._fields[name] = number_field(
            label, unit, getattr(self._form, name), LIMITS[name], change, hint=hint
        )

    def _choose_law(self, law: str) -> None:
        if law == self._form.law or self._quiet:
            return
        self._form.law = law
        self._form.mu = reference_of(law)
        self.refresh()
        self._changed()

    def _choose_heating(self, heating: str) -> None:
        self._set("heating", heating)

    def _set(self, name: str, value: object) -> None:
        if self._quiet or getattr(self._form, name) == value:
            return
        setattr(self._form, name, value)
        self._changed()

    def _reset(self) -> None:
        for name, value in vars(BearingForm()).items():
            setattr(self._form, name, value)
        self.refresh()
        self._changed()
