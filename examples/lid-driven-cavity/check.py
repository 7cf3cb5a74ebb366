#!/usr/bin/env python3
"""Checks a results folder of this example against Ghia, Ghia & Shin, J. Comput. Phys. 48 (1982) 387, tables I and II."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import COLOURS, INK, FluidCheck  # noqa: E402

Y = [0.9766, 0.9688, 0.9609, 0.9531, 0.8516, 0.7344, 0.6172, 0.5, 0.4531, 0.2813, 0.1719, 0.1016, 0.0703, 0.0625, 0.0547]
U = [0.84123, 0.78871, 0.73722, 0.68717, 0.23151, 0.00332, -0.13641, -0.20581, -0.21090, -0.15662, -0.10150, -0.06434,
     -0.04775, -0.04192, -0.03717]
X = [0.9688, 0.9609, 0.9531, 0.9453, 0.9063, 0.8594, 0.8047, 0.5, 0.2344, 0.2266, 0.1563, 0.0938, 0.0781, 0.0703, 0.0625]
V = [-0.05906, -0.07391, -0.08864, -0.10313, -0.16914, -0.22445, -0.24533, 0.05454, 0.17527, 0.17507, 0.16077, 0.12317,
     0.10890, 0.10091, 0.09233]

run = FluidCheck(__doc__)
_, fields, x, y = list(run.fields())[-1]
velocity = fields["velocity"][0]


def middle(values):
    """Average of the two layers of cells beside the middle."""
    n = len(values) // 2
    return 0.5 * (values[n - 1] + values[n])


u, v = middle(velocity[:, :, 0].T), middle(velocity[:, :, 1])
if run.full:
    for name, place, found, table_place, table in (("u", y, u, Y, U), ("v", x, v, X, V)):
        inside = np.interp(table_place, place, found)
        run.below(f"largest difference from the table of {name}", np.abs(inside - table).max(), 0.01)
    # The extrema of the table are off by 1.5, 2.5 and 3.4 % themselves: README.md.
    run.between("lowest u on the vertical middle line over the exact one", 0.993, u.min() / -0.21404, 1.003)
    run.between("highest v on the horizontal middle line over the exact one", 0.993, v.max() / 0.17957, 1.003)
    run.between("lowest v over the exact one", 0.993, v.min() / -0.25380, 1.003)
if run.picture:
    figure, (left, right) = run.axes(9, 4.2, ncols=2)
    left.imshow(np.linalg.norm(velocity, axis=-1), interpolation="nearest", origin="lower", extent=(0, 1, 0, 1), cmap="Blues", vmax=0.6)
    left.streamplot(x, y, velocity[:, :, 0], velocity[:, :, 1], color=INK, linewidth=0.6, arrowsize=0.7, density=0.8)
    left.set(xlabel="x / L", ylabel="y / L", title="speed and streamlines, Re = 100", xlim=(0, 1), ylim=(0, 1))
    right.plot(y, u, color=COLOURS[0], label="u along the vertical middle line")
    right.plot(Y, U, "o", ms=4, color=COLOURS[0])
    right.plot(x, v, color=COLOURS[1], label="v along the horizontal one")
    right.plot(X, V, "s", ms=4, color=COLOURS[1])
    right.set(xlabel="y / L, x / L", ylabel="velocity / U", title="symbols: Ghia et al. 1982")
    right.legend(frameon=False, fontsize=8)
    run.save(figure)
run.finish()
