"""A multi-storey shear building on the bearing, in place of the rigid structure."""

from dcfp.analysis.building.response import BuildingResponse as BuildingResponse
from dcfp.analysis.building.response import respond_building as respond_building
from dcfp.analysis.building.shear_building import Rayleigh as Rayleigh
from dcfp.analysis.building.shear_building import ShearBuilding as ShearBuilding
from dcfp.analysis.building.shear_building import StiffnessProportional as StiffnessProportional
from dcfp.analysis.building.shear_building import uniform_building as uniform_building
