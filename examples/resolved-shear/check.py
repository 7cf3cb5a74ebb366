#!/usr/bin/env python3
"""Checks a results folder of this example against README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from results_check import ResultsCheck  # noqa: E402

run = ResultsCheck(__doc__)
run.resolved_run(largest_overlap=0.03)
if run.full:
    run.viscosity_between(4, 10)
run.finish()
