#!/usr/bin/env python3
"""Checks a results folder of this example against the closed form of README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import COLOURS, INK, FluidCheck  # noqa: E402

run = FluidCheck(__doc__)
y, velocity = run.profiles["position"], run.profiles["velocity_x"][-1]
if run.full:
    run.below("error of the parabola, cell by cell", np.abs(velocity - 4 * y * (1 - y)).max(), 1e-9)
    # Mean of (du/dy)^2 / Re over the centres of N cells; the integral is 16/3.
    expected = 16 / 3 * (1 - 1 / len(y) ** 2)
    run.below("error of the dissipation from gradients", abs(
        run.series["dissipation_from_gradients"][-1] / expected - 1), 1e-8)
    # Populations carry normal stresses too, of the order of shear rate cell^2 / viscosity times the shear stress.
    run.below("error of the dissipation from populations", abs(
        run.series["dissipation_from_populations"][-1] / expected - 1), 2 * 16 / 3 / len(y) ** 4)
    work = 8 * run.series["mean_velocity_x"][-1]
    run.between("power of the force over dissipation, the rest being the size of the cells", 1,
                work / run.series["dissipation_from_gradients"][-1], 1 + 2 / len(y) ** 2)
if run.picture:
    figure, axes = run.axes()
    fine = np.linspace(0, 1, 200)
    axes.plot(4 * fine * (1 - fine), fine, color=COLOURS[0], label="exact")
    axes.plot(velocity, y, "o", color=COLOURS[1], label="16 cells, relaxation time 2")
    axes.set(xlabel="velocity / U", ylabel="y / L", title="Poiseuille flow")
    axes.title.set_color(INK)
    axes.legend(frameon=False)
    run.save(figure)
run.finish()
