"""A multi-storey shear building on the bearing, in place of the rigid structure."""

from dcfp.building.damping import Rayleigh as Rayleigh
from dcfp.building.damping import StiffnessProportional as StiffnessProportional
from dcfp.building.energy import BuildingEnergy as BuildingEnergy
from dcfp.building.respond import respond_building as respond_building
from dcfp.building.response import BuildingResponse as BuildingResponse
from dcfp.building.shear_building import ShearBuilding as ShearBuilding
from dcfp.building.shear_building import uniform_building as uniform_building
