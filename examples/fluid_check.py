"""What the check.py of every fluid example shares: reading a results folder, statements, and the picture.

Needs python3-numpy and python3-h5py, for --picture python3-matplotlib too (Debian packages).
"""
import argparse
import json
import pathlib
import sys

import h5py
import numpy as np

INK, GREY, COLOURS = "#22303c", "#8a949c", ("#2b6cb0", "#c8442f", "#5b8c3e", "#b58a2a", "#7a5ea8")


class FluidCheck:
    """Prints one line per statement; `finish` ends with status 1 if one of them does not hold."""

    def __init__(self, description):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("results", type=pathlib.Path, help="output folder of the run")
        parser.add_argument("--quick", action="store_true", help="check only what holds for any run, however short")
        parser.add_argument("--picture", type=pathlib.Path, help="draw the comparison into this file")
        arguments = parser.parse_args()
        self.full, self.picture, self.folder = not arguments.quick, arguments.picture, arguments.results
        self.summary = json.loads((self.folder / "summary.json").read_text())
        with h5py.File(self.folder / "results.h5", "r") as file:
            self.series = {name: data[:] for name, data in file["series"].items()}
            self.profiles = {name: data[:] for name, data in file["profiles"].items()}
        self.failures = 0
        self.check("run to its end", self.summary["status"] in ("finished", "steady"), self.summary["status"])
        self.below("drift of the mean density", np.abs(np.diff(self.series["mass_deviation"])).max(initial=0), 1e-10)

    def fields(self):
        """(time, {name: array}, x, y) of every file of fields, in order of time."""
        for path in sorted((self.folder / "fields").glob("*.h5")):
            with h5py.File(path, "r") as file:
                origin, spacing = file.attrs["origin"], file.attrs["spacing"]
                fields = {name: data[:] for name, data in file.items()}
                shape = next(iter(fields.values())).shape
                x, y = (origin[a] + spacing[a] * (np.arange(shape[2 - a]) + 0.5) for a in (0, 1))
                yield file.attrs["time"], fields, x, y

    def check(self, statement, holds, found):
        self.failures += not holds
        print(f"{'ok   ' if holds else 'FAILS'}  {statement}: {found}")

    def below(self, statement, value, bound):
        self.check(f"{statement} below {bound:g}", value < bound, f"{value:.3g}")

    def between(self, statement, low, value, high):
        self.check(f"{statement} between {low:g} and {high:g}", low <= value <= high, f"{value:.6g}")

    def axes(self, width=6.4, height=4.2, **options):
        """Figure and axes in the style of the examples."""
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        figure, axes = plt.subplots(figsize=(width, height), dpi=96, **options)
        for each in np.atleast_1d(axes):
            each.spines[["top", "right"]].set_visible(False)
            each.tick_params(colors=INK)
        return figure, axes

    def save(self, figure):
        figure.tight_layout()
        figure.savefig(self.picture)
        print(self.picture)

    def finish(self):
        sys.exit(self.failures > 0)
