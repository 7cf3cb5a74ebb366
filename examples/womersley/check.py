#!/usr/bin/env python3
"""Checks a results folder of this example against the closed form of README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import COLOURS, INK, FluidCheck  # noqa: E402

REYNOLDS, WOMERSLEY, FORCE = 20, 4, 0.8
OMEGA = WOMERSLEY**2 / REYNOLDS
PERIOD = 2 * np.pi / OMEGA


def exact(y, t):
    """y from the middle of the channel."""
    root = np.sqrt(1j * OMEGA * REYNOLDS)
    return (FORCE / (1j * OMEGA) * (1 - np.cosh(root * y) / np.cosh(root)) * np.exp(1j * OMEGA * t)).real


run = FluidCheck(__doc__)
y, times, velocity = run.profiles["position"] - 1, run.profiles["time"], run.profiles["velocity_x"]
if run.full:
    last = times > times[-1] - PERIOD
    errors = [np.abs(u - exact(y, t)).max() for t, u in zip(times[last], velocity[last])]
    run.below("largest error over the last period, over the largest velocity",
              max(errors) / np.abs(velocity[last]).max(), 2e-3)
if run.picture:
    figure, axes = run.axes()
    fine = np.linspace(-1, 1, 200)
    for eighth in range(0, 8):
        k = np.abs(times - (times[-1] - PERIOD * (1 - eighth / 8))).argmin()
        colour = COLOURS[eighth % 4]
        axes.plot(exact(fine, times[k]), fine, color=colour, lw=1)
        axes.plot(velocity[k], y, "o", ms=3, color=colour, label=f"{eighth}/8 period" if eighth < 4 else None)
    axes.set(xlabel="velocity / U", ylabel="y / L", title="Womersley flow at eighths of a period (lines: exact)")
    axes.title.set_color(INK)
    axes.legend(frameon=False, loc="lower right", fontsize=8)
    run.save(figure)
run.finish()
