#!/usr/bin/env python3
"""Checks a results folder of this example against README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from results_check import ResultsCheck  # noqa: E402

run = ResultsCheck(__doc__)
run.any_run(largest_overlap=0.02)
if run.full:
    run.viscosity_between(12.9, 14.3)
    run.between("contact", 5.2, run.parts["contact"], 7.0)
    run.between("lubrication, normal", 2.6, run.parts["lubrication_normal"], 3.3)
    run.between("lubrication, tangential", 2.1, run.parts["lubrication_tangential"], 2.8)
    run.between("lubrication, rotational", -0.1, run.parts["lubrication_rotational"], 0.1)
    run.between("slope of the velocity profile", 0.97, run.summary["velocity_slope"], 1.03)
    run.between("N2", -10, run.summary["N2"]["mean"], -1)
run.finish()
