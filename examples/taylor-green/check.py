#!/usr/bin/env python3
"""Checks a results folder of this example against the closed form of README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import COLOURS, GREY, INK, FluidCheck  # noqa: E402

REYNOLDS, K = 100, 2 * np.pi
DECAY = K**2 / REYNOLDS  # of the velocity: exp(-2 DECAY t)

run = FluidCheck(__doc__)
time, energy = run.series["time"], run.series["kinetic_energy"]
if run.full:
    slope = np.polyfit(time, np.log(energy), 1)[0]
    run.between("viscosity from the decay of the energy over the viscosity", 0.999, -slope / (4 * DECAY), 1.001)
    run.between("dissipation over loss of energy", 0.995,
                np.trapz(run.series["dissipation_from_populations"], time) / (energy[0] - energy[-1]), 1.005)
    t, fields, x, y = list(run.fields())[-1]
    x, y = np.meshgrid(x, y)
    decay = np.exp(-2 * DECAY * t)
    u = -decay * np.cos(K * x) * np.sin(K * y)
    pressure = -decay**2 / 4 * (np.cos(2 * K * x) + np.cos(2 * K * y))
    stress = 2 / REYNOLDS * decay * K * np.sin(K * x) * np.sin(K * y)

    def error(found, exact):
        return np.sqrt(np.mean((found - exact) ** 2) / np.mean(exact**2))

    run.below("error of the velocity", error(fields["velocity"][0, :, :, 0], u), 2e-3)
    found = fields["pressure"][0]
    run.below("error of the pressure", error(found - found.mean(), pressure), 2e-2)
    run.below("error of the viscous stress xx", error(fields["viscous_stress"][0, :, :, 0], stress), 1e-2)
if run.picture:
    figure, (left, right) = run.axes(9, 4, ncols=2)
    _, fields, x, y = next(run.fields())
    speed = np.linalg.norm(fields["velocity"][0], axis=-1)
    left.imshow(speed, origin="lower", extent=(0, 1, 0, 1), cmap="Blues")
    left.streamplot(x, y, fields["velocity"][0, :, :, 0], fields["velocity"][0, :, :, 1], color=INK, linewidth=0.6,
                    arrowsize=0.7, density=0.9)
    left.set(xlabel="x / L", ylabel="y / L", title="speed and streamlines at the start")
    right.semilogy(time, energy[0] * np.exp(-4 * DECAY * time), color=GREY, label="exact")
    right.semilogy(time[::10], energy[::10], "o", ms=4, color=COLOURS[0], label="64 x 64 cells")
    right.set(xlabel="time U / L", ylabel="kinetic energy / rho U^2")
    right.legend(frameon=False)
    run.save(figure)
run.finish()
