#!/usr/bin/env python3
"""Checks a results folder of this example against the closed form of README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import COLOURS, INK, FluidCheck  # noqa: E402

REYNOLDS = 10


def exact(y, t):
    n = np.arange(1, 200)[:, None]
    return y + (2 * (-1.0) ** n / (n * np.pi) * np.exp(-(n * np.pi) ** 2 * t / REYNOLDS) * np.sin(n * np.pi * y)).sum(0)


run = FluidCheck(__doc__)
y, times, velocity = run.profiles["position"], run.profiles["time"], run.profiles["velocity_x"]
if run.full:
    errors = [np.abs(u - exact(y, t)).max() for t, u in zip(times, velocity) if t >= 0.5]
    run.below("largest error of the start-up from time 0.5 on", max(errors), 2e-3)
    run.below("error of the steady profile", np.abs(velocity[-1] - y).max(), 1e-9)
    run.below("error of the dissipation from gradients", abs(
        run.series["dissipation_from_gradients"][-1] * REYNOLDS - 1), 1e-8)
    # Populations carry normal stresses too, of the order of shear rate cell^2 / viscosity times the shear stress.
    run.below("error of the dissipation from populations", abs(
        run.series["dissipation_from_populations"][-1] * REYNOLDS - 1), 2 * (REYNOLDS / len(y) ** 2) ** 2)
if run.picture:
    figure, axes = run.axes()
    fine = np.linspace(0, 1, 200)
    for shown, colour in zip((0.5, 1, 2, 4, 25), COLOURS):
        k = np.abs(times - shown).argmin()
        axes.plot(exact(fine, times[k]), fine, color=colour)
        axes.plot(velocity[k], y, "o", ms=3.5, color=colour, label=f"t = {times[k]:.3g} L/U")
    axes.set(xlabel="velocity / U", ylabel="y / L", title="Start-up of Couette flow, Re = 10 (lines: exact)")
    axes.title.set_color(INK)
    axes.legend(frameon=False)
    run.save(figure)
run.finish()
