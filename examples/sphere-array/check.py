#!/usr/bin/env python3
"""Checks a results folder of this example against Zick & Homsy, J. Fluid Mech. 115 (1982) 13, table 2."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import numpy as np  # noqa: E402
from fluid_check import INK, FluidCheck  # noqa: E402

REYNOLDS, FORCE, RADIUS, DRAG = 0.1, 250.915, 0.310175, 4.29159

run = FluidCheck(__doc__)
velocity = run.series["mean_velocity_x"][-1]
if run.full:
    drag = FORCE * REYNOLDS / (6 * np.pi * RADIUS * velocity)
    run.between("drag coefficient over that of Zick & Homsy", 0.97, drag / DRAG, 1.03)
    run.between("solid fraction of the voxels over 0.125", 0.98, run.summary["solid_fraction"] / 0.125, 1.02)
    run.between("power of the force over dissipation from gradients", 0.995,
                FORCE * velocity / run.series["dissipation_from_gradients"][-1], 1.02)
    run.between("power of the force over dissipation from populations", 1,
                FORCE * velocity / run.series["dissipation_from_populations"][-1], 1.05)
if run.picture:
    figure, axes = run.axes(5, 4.2)
    _, fields, x, y = list(run.fields())[-1]
    middle = len(fields["solid"]) // 2
    speed = np.ma.masked_where(fields["solid"][middle] > 0, np.linalg.norm(fields["velocity"][middle], axis=-1))
    image = axes.imshow(speed, origin="lower", extent=(0, 1, 0, 1), cmap="Blues")
    axes.streamplot(x, y, fields["velocity"][middle, :, :, 0], fields["velocity"][middle, :, :, 1], color=INK,
                    linewidth=0.6, arrowsize=0.7)
    axes.set(xlabel="x / L", ylabel="y / L", title="middle plane, flow to the right", xlim=(0, 1), ylim=(0, 1))
    figure.colorbar(image, label="speed / U")
    run.save(figure)
run.finish()
