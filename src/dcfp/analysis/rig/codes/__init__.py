"""Prototype tests that codes ask for, and what the codes want of their results."""

from dcfp.analysis.rig.codes.choice import judge_tests as judge_tests
from dcfp.analysis.rig.codes.choice import prototype_program as prototype_program
from dcfp.analysis.rig.codes.choice import prototype_programs as prototype_programs
from dcfp.analysis.rig.codes.criterion import Criterion as Criterion
from dcfp.analysis.rig.codes.design import PrototypeDesign as PrototypeDesign
from dcfp.analysis.rig.codes.property_factors import PropertyFactor as PropertyFactor
from dcfp.analysis.rig.codes.property_factors import property_factors as property_factors
