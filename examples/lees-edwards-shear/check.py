#!/usr/bin/env python3
"""Checks a results folder of this example against the closed form of README.md."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import COLOURS, GREY, INK, FluidCheck  # noqa: E402

REYNOLDS, AMPLITUDE, K = 200, 0.1, 2 * np.pi
START = np.array([K, K])


def exact(t):
    """Amplitude of u_y = amplitude sin(kx x + ky y + kx t / 2), and its wave vector."""
    k = np.array([K, K - K * t])
    decay = np.exp(-(K**2 * t + K**2 * t - K**2 * t**2 + K**2 * t**3 / 3) / REYNOLDS)
    return -AMPLITUDE * np.linalg.norm(START) * decay * K / (k @ k), k


run = FluidCheck(__doc__)
times, ratios, phases, amplitudes = [], [], [], []
for t, fields, x, y in run.fields():
    amplitude, k = exact(t)
    x, y = np.meshgrid(x, y)
    mode = 2 * np.mean(fields["velocity"][0, :, :, 1] * np.exp(-1j * (k[0] * x + k[1] * y + K * t / 2))) * 1j
    times.append(t)
    amplitudes.append(abs(mode))
    ratios.append(mode.real / amplitude)
    phases.append(np.angle(mode / amplitude))
if run.full:
    run.below("largest error of the amplitude", np.abs(np.array(ratios) - 1).max(), 3e-3)
    run.below("largest error of the phase", np.abs(phases).max(), 1e-6)
    run.below("mean momentum", np.abs(run.series["momentum_x"]).max(), 1e-9)
if run.picture:
    figure, (left, right) = run.axes(9, 4, ncols=2)
    _, fields, x, y = list(run.fields())[5]
    left.imshow(fields["velocity"][0, :, :, 1], origin="lower", extent=(0, 1, 0, 1), cmap="RdBu_r")
    left.set(xlabel="x / L", ylabel="y / L", title="velocity along y at strain 0.5")
    fine = np.linspace(0, 2, 200)
    right.plot(fine, [abs(exact(t)[0]) for t in fine], color=GREY, label="exact")
    right.plot(times, amplitudes, "o", ms=4, color=COLOURS[0], label="64 x 64 cells")
    right.set(xlabel="strain", ylabel="amplitude / U", title="Kelvin mode")
    right.title.set_color(INK)
    right.legend(frameon=False)
    run.save(figure)
run.finish()
