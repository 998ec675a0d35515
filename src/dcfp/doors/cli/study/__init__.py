"""Studies: many analyses over records, intensities and bearings, into a store that survives an interruption.

dcfp study STUDY.toml is short for dcfp study run STUDY.toml.
"""

#: Each command of the group, and what it does.
COMMANDS = {
    "new": "writes a study file to start from",
    "plan": "how many analyses a study has, and how long they will take",
    "run": "runs a study, or what is left of it",
    "show": "what is in a store",
    "histories": "the response history analysis behind one case of a store",
    "export": "a store as NetCDF or CSV",
    "ida": "incremental dynamic analysis: curves and their quantiles",
    "fragility": "probability that a capacity is exceeded, by intensity",
    "bounds": "envelope over property factors and temperatures",
    "sensitivity": "Sobol indices of the sampled factors",
    "chart": "design chart: displacement over friction and radius",
}
#: The command that a study file alone asks for.
USUAL = "run"
