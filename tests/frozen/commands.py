"""The command lines whose results are frozen; --json is added unless a file is written."""

import shlex

#: Quick ones, which the tests run.
QUICK = """
respond NCC KNA LPG IVD --pgv 0.25 0.5 0.75 1.0
respond NCC --pgv 0.5 --heating precise
respond NCC --pgv 0.5 --heating none
respond NCC IVD --pgv 1.0 --friction constant --mu 0.05
respond NCC IVD --pgv 1.0 --friction constantinou1990
respond NCC IVD --pgv 1.0 --friction kumar2015
respond NCC IVD --pgv 1.0 --friction kim2023-third
respond NCC IVD --pgv 1.0 --friction kim2023-two-thirds
respond NCC IVD --pgv 1.0 --friction lomiento2013
respond NCC IVD --pgv 1.0 --friction fitted
respond NCC IVD --pgv 0.5 --bearing own.toml
test dependency
test asce --tests T02 T07 --compare
test asce7-16 --displacement 300 --period 3 --checks
predict NCC LPG --pgv 0.5 1.0
predict --pgv-only 0.25 0.5 1.0
compare NCC LPG --pgv 0.5
codes NCC --pgv 0.5
codes --asce 1.5 0.6 --bounds 0.85 1.6
codes --eurocode 3
codes --japan 2
spectrum NCC --pgv 0.5 --periods 0.5 1 2 3 5
building NCC --pgv 0.5
identify slow.csv middle.csv fast.csv --hold-out light.csv --fit mu_0 speed_drop
records NCC
records pulse.txt --units m/s2
study run bounds.toml --out bounds.zarr
study show bounds.zarr
study bounds bounds.zarr
study ida bounds.zarr --at lambda=1 ambient=20
"""

#: All others.
SLOW = """
respond NCC KNA LPG IVD --pgv 0.25 0.5 0.75 1.0 --heating precise
respond NCC KNA LPG IVD --pgv 0.25 0.5 0.75 1.0 --heating none
respond NCC KNA LPG IVD
respond NCC --pgv 0.5 1.0 --radius 3000 4500 --slider 350 --pressure 50 --stiffness 1500 --capacity 100
respond NCC --pgv 0.5 --thickness 30
respond NCC --pgv 0.5 --thickness 30 --heating precise --ambient -10
respond NCC --pgv 0.5 --mu 0.05 --ambient 40
respond NCC --pgv 0.5 --step 0.002 --tail 5 --tolerance 0.005
respond pulse.txt drifting.txt --units m/s2 --baseline --high-pass 0.2
respond P695 --pgv 0.5
respond NCC --pgv 0.5 --out histories.csv
respond NCC KNA --pgv 0.5 1.0 --out peaks.csv
test asce
test asce --compare
test asce --checks
test asce7-16 --displacement 300 --period 3
test asce7-16 --displacement 300 --period 3 --total-displacement 360 --friction kumar2015
test en15129 --displacement 300 --period 3
test en15129 --displacement 300 --period 3 --checks
test dependency --radius 3000 2500 --friction kumar2015 --heating precise
test dependency --friction lomiento2013
test asce --tests T06 --thickness 30 --out test.csv
test dependency --out cycles.csv
test program.toml --measured slow=slow.csv fast=fast.csv
test slow.csv
predict NCC LPG --pgv 0.5 1.0 --interval
predict P695 --pgv 0.5
predict --pgv-only 0.5 --interval
predict --pgv-only 0.5 1.0 --allow 300
predict NCC --pgv 0.5 --nominal-mu 0.05 --eps 0.3 --zeta 1.4 --average-slope 900 --threshold 0.3
predict NCC --pgv 0.5 --friction kumar2015 --radius 3000
predict NCC LPG --pgv 0.5 --out predictions.csv
compare NCC KNA LPG IVD --pgv 0.25 0.5 0.75 1.0
compare P695 --pgv 0.25 0.5 --held-out
compare NCC IVD --pgv 0.25 1.0 --friction lomiento2013
compare NCC LPG --pgv 0.5 --out compared.csv
codes NCC LPG --pgv 0.5 1.0 --fixed-base-period 0.5 --height 15 --site-class B --plan 30 --fault-distance 5 --weight-above 0.8
codes NCC --pgv 0.5 --bounds 0.85 1.6
codes P695-FF --pgv 0.5 --of-set mean
codes P695-FF --pgv 0.5 --of-set 84
codes --asce 1.5 0.6 8 --details --nominal-mu 0.05
codes --asce 1.5 0.6 --fixed-base-period 0.5 --height 15 --site-class C --plan 30 --fault-distance 20 --weight-above 0.8
codes --eurocode 3 --ground C --type 2
codes --japan 1
codes --japan 3 --friction constant --mu 0.06 --radius 3000
codes --asce 1.5 0.6 --out codes.csv
spectrum NCC LPG --pgv 0.5
spectrum NCC --pgv 0.5 --damping 0.02
spectrum P695-FF --pgv 0.5 --periods 0.5 1 2 3 5
spectrum KNA --periods 0.5 1 2 --out spectrum.csv
building NCC KNA --pgv 0.25 1.0 --heating none
building LPG --pgv 0.5 --storeys 2 --fixed-base-period 0.3 --damping 0.05 --friction kumar2015
building IVD --pgv 0.5 --out building.csv
identify slow.csv middle.csv fast.csv light.csv
identify slow.csv middle.csv fast.csv --hold-out light.csv --fix temperature_rate=0.007
identify slow.csv middle.csv fast.csv --heating precise --fit mu_0 speed_drop
identify light.csv slow.csv --radius 3000 --fit mu_0
records
records NCC LPG KNA IVD
records NCC --out record.csv
records NCC LPG --out measures.csv
study run few.toml --out few.zarr
study show few.zarr
study ida few.zarr
study ida few.zarr --quantity force_ratio --quantiles 0.1 0.5 0.9 --out ida.csv
study fragility few.zarr --capacity 300
study fragility few.zarr --capacity 300 --further-dispersion 0.2 0.1 --confidence 0.8 --seed 3 --out fragility.csv
study bounds bounds.zarr --over lambda --at ambient=20 --quantities peak_displacement force_ratio
study bounds bounds.zarr --out bounds.csv
study export bounds.zarr --out analyses.csv
study run sampled.toml --out sampled.zarr
study sensitivity sampled.zarr
study sensitivity sampled.zarr --logarithm --quantity force_ratio --over-records 0.84 --out sobol.csv
study run chart.toml --out chart.zarr
study chart chart.zarr --allow 250
study chart chart.zarr --allow 250 --out chart.csv
study histories bounds.toml --at record=NCC pgv=0.5 lambda=1 ambient=20
study run kinds.toml --out kinds.zarr
study export kinds.zarr --out kinds.csv
study run procedures.toml --out procedures.zarr
study export procedures.zarr --out procedures.csv
report scenario.toml
export scenario.toml --out scenario.csv
reproduce
verify
"""


def command_lines(text: str) -> list[list[str]]:
    """Return the words of each command of a list."""
    return [shlex.split(line) for line in text.split("\n") if line]
