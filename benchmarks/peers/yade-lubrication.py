# -*- encoding=utf-8 -*-
"""Sheared bidisperse suspension in Yade with its implicit lubrication law (resolution 0: exact root of the implicit step).

yade -n -x -j2 yade-lubrication.py START.yade step=1e-4 warmup=0.3 strain=0.02 friction=0
Units: smallest diameter, shear rate and fluid viscosity are 1; density is then the Stokes number.

Radii are shrunk by the factor 1 - roughness: Yade's asperities touch at a gap of 2 roughness times the mean radius, and
so touch here where the smooth spheres of the other programs do. A pair that starts overlapping sends the law into endless
recursion (it takes the gap as first film thickness), so all spheres start smaller and swell during the first steps. No Stokes drag: Yade has none in a sheared flow.
"""
import os
import sys
import time

import numpy as np
from yade import utils

options = dict(step=1e-4, warmup=0.3, warmup_step=2e-4, strain=0.02, friction=0.0, margin=0.02)
for argument in sys.argv[2:]:
    key, value = argument.split("=")
    if key not in options:
        raise SystemExit(f"{key}: unknown option (known: {', '.join(options)})")
    options[key] = float(value)

density, viscosity, stiffness = 0.1, 1.0, 2.5e5
roughness = 0.0005  # contact at a gap of 2 roughness mean_radius = 0.001 d_eff for equal spheres
shrinkage, swelling_steps = 0.0015, 100
outer_cutoff = 0.05  # gap over mean radius, = 0.05 d_eff for equal spheres

start = sys.argv[1]
with open(start) as file:
    lx, ly, lz, offset = (float(v) for v in file.readline().lstrip("#").split())
table = np.loadtxt(start)

O.periodic = True
O.cell.hSize = Matrix3(lx, offset, 0, 0, ly, 0, 0, 0, lz)
O.cell.flipFlippable = True
materials = {}
for radius in np.unique(table[:, 3]):
    # film and asperities are two springs in series, each twice as stiff as the contact; kn = young radius, ks = kn poisson
    materials[radius] = O.materials.append(
        FrictMat(young=2 * stiffness / radius, poisson=1 / 7, density=density, frictionAngle=np.arctan(options["friction"])))
for x, y, z, radius, u, v, w, wx, wy, wz in table:
    ball = utils.sphere((x, y, z), radius * (1 - roughness) / (1 + shrinkage), material=materials[radius])
    ball.state.vel, ball.state.angVel = Vector3(u - y, v, w), Vector3(wx, wy, wz)  # the first step adds the mean flow
    O.bodies.append(ball)
O.cell.velGrad = Matrix3(0, 1, 0, 0, 0, 0, 0, 0, 0)

reach = 1 + outer_cutoff / 2
law = Law2_ScGeom_ImplicitLubricationPhys(resolution=0, MaxDist=outer_cutoff)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=reach)], verletDist=options["margin"], allowBiggerThanPeriod=True),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(interactionDetectionFactor=reach)],
        [Ip2_FrictMat_FrictMat_LubricationPhys(eta=viscosity, eps=roughness)], [law]),
    NewtonIntegrator(damping=0),
]


def parts():
    """Contact, normal and tangential lubrication shear stress, tension positive."""
    normal_contact, shear_contact, normal_film, shear_film, _ = law.getTotalStresses()
    return np.array([s[0, 1] for s in (normal_contact + shear_contact, normal_film, shear_film)])


O.dt = options["warmup_step"]
O.step()
for _ in range(swelling_steps):
    utils.growParticles((1 + shrinkage) ** (1 / swelling_steps), updateMass=False)
    O.step()
O.run(max(1, round(options["warmup"] / O.dt)), True)
O.dt = options["step"]
steps, samples = round(options["strain"] / O.dt), []
chunk = max(1, steps // 20)
wall, processor = 0.0, 0.0
for _ in range(20):
    before = time.perf_counter(), time.process_time()
    O.run(chunk, True)
    wall, processor = wall + time.perf_counter() - before[0], processor + time.process_time() - before[1]
    samples.append(parts())
mean = np.mean(samples, axis=0)
slope = np.polyfit([b.state.pos[1] for b in O.bodies], [b.state.vel[0] for b in O.bodies], 1)[0]
strain = 20 * chunk * O.dt
contacts = 2 * sum(1 for i in O.interactions if i.phys.contact) / len(O.bodies)
print(f"steps {20 * chunk} strain {strain:g} wall_seconds {wall:.3f} processor_seconds {processor:.3f} threads {os.environ.get('OMP_NUM_THREADS', '?')}")
print(f"viscosity {1 + mean.sum():.4f} contact {mean[0]:.4f} lubrication_normal {mean[1]:.4f} lubrication_tangential {mean[2]:.4f}")
print(f"contacts {contacts:.4f} interactions {O.interactions.countReal()} velocity_slope {slope:.4f}", flush=True)
