#!/usr/bin/env python3
"""Checks a results folder of this example against README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from results_check import ResultsCheck  # noqa: E402

run = ResultsCheck(__doc__)
run.any_run(largest_overlap=0.03)
if run.full:
    run.viscosity_between(18.5, 25)
    total = run.summary["relative_viscosity"]["mean"]
    run.between("share of contacts", 0.65, run.parts["contact"] / total, 0.85)
    run.between("N2", -15, run.summary["N2"]["mean"], -3)
run.finish()
