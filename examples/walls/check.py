#!/usr/bin/env python3
"""Checks a results folder of this example against README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from results_check import ResultsCheck  # noqa: E402

run = ResultsCheck(__doc__)
run.any_run(largest_overlap=0.02)
if run.full:
    run.between("slope of the velocity profile", 0.95, run.summary["velocity_slope"], 1.05)
    run.viscosity_between(6.4, 7.9)
    run.between("contact", 1.5, run.parts["contact"], 2.5)
run.finish()
