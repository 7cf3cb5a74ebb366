"""What the check.py of every example shares: reading a results folder, and what holds for any run of the model."""
import argparse
import json
import pathlib
import sys


class ResultsCheck:
    """Prints one line per statement; `finish` ends with status 1 if one of them does not hold."""

    def __init__(self, description):
        parser = argparse.ArgumentParser(description=description)
        parser.add_argument("results", type=pathlib.Path, help="output folder of the run")
        parser.add_argument("--quick", action="store_true",
                            help="check only what holds for any run of the model, however short and small")
        arguments = parser.parse_args()
        self.full = not arguments.quick
        self.summary = json.loads((arguments.results / "summary.json").read_text())
        self.parts = {name: part["mean"] for name, part in self.summary["contribution"].items()}
        self.failures = 0

    def check(self, statement, holds, found):
        self.failures += not holds
        print(f"{'ok   ' if holds else 'FAILS'}  {statement}: {found}")

    def between(self, statement, low, value, high):
        self.check(f"{statement} between {low:g} and {high:g}", low <= value <= high, f"{value:.4g}")

    def viscosity_between(self, low, high):
        """The bounds are widened by two error bars of the run."""
        mean, error = (self.summary["relative_viscosity"][key] for key in ("mean", "error"))
        self.check(f"relative viscosity between {low:g} and {high:g}", low - 2 * error <= mean <= high + 2 * error,
                   f"{mean:.3f} +- {error:.3f}")

    def any_run(self, largest_overlap):
        """What holds for the lubricated model."""
        stresslet, solid_fraction = self.parts["stresslet"], self.summary["solid_fraction"]
        self.check("stresslet is 2.5 times the solid fraction", abs(stresslet - 2.5 * solid_fraction) < 1e-9,
                   f"{stresslet:.6g}")
        self.balances(0.01 if self.full else 0.05, largest_overlap)

    def resolved_run(self, largest_overlap):
        """What holds with the fluid resolved. A single sphere has a stresslet of 2.5, neighbours add to it."""
        closure = self.summary["stress_closure"]
        self.balances(0.03, largest_overlap)
        self.between("stresslet over that of single spheres", 1, self.parts["stresslet"] /
                     (2.5 * self.summary["solid_fraction"]), 3)
        self.check("summed stress equals the flux through the sheared plane within 0.5 %",
                   abs(closure["mean"]) < 0.005 + 2 * closure["error"], f"{closure['mean']:+.2%} +- {closure['error']:.2%}")
        self.between("lowest density", 0.95, self.summary["lowest_density"], 1)
        self.between("highest density", 1, self.summary["highest_density"], 1.05)

    def balances(self, tolerance, largest_overlap):
        viscosity = self.summary["relative_viscosity"]["mean"]
        dissipated = self.summary["relative_viscosity_from_dissipation"]["mean"]
        self.check("run to its end", self.summary["status"] == "finished", self.summary["status"])
        self.check("parts add up to the viscosity", abs(1 + sum(self.parts.values()) - viscosity) < 1e-9 * viscosity,
                   f"1 + {sum(self.parts.values()):.10g} and {viscosity:.10g}")
        self.check(f"stress equals dissipation within {tolerance:.0%}", abs(dissipated / viscosity - 1) < tolerance,
                   f"{viscosity:.4g} and {dissipated:.4g}")
        self.between("largest overlap", 0, self.summary["largest_overlap"], largest_overlap)

    def finish(self):
        sys.exit(self.failures > 0)
