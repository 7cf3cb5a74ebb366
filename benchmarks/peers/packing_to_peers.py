#!/usr/bin/python3
"""Turns a configuration written by stresslet into start files for LAMMPS and Yade.

Input: extended XYZ (the last frame counts), Lattice="Lx 0 0  offset Ly 0  0 0 Lz", positions in [0, L), full velocities
around the mean flow u_x = shear_rate (y - Ly/2), columns pos, radius, velo; id and angular_velocity are used where present.
Output: PREFIX.lammps, a data file (atom_style sphere, triclinic, one atom type per diameter), and PREFIX.yade, plain text.
Both peers have the mean flow u_x = shear_rate y, so shear_rate Ly/2 is added to every u_x. Angular velocities missing
from the file start at half the vorticity, -shear_rate/2 about z.
"""
import argparse
import re
from collections import namedtuple

import numpy as np

Packing = namedtuple("Packing", "length offset position radius velocity angular_velocity")


def read_last_frame(path):
    """Returns comment line and rows of the last frame."""
    comment, rows = None, None
    with open(path) as file:
        while (line := file.readline()).strip():
            count = int(line)
            comment, rows = file.readline(), [file.readline().split() for _ in range(count)]
    if not rows or len(rows[-1]) == 0:
        raise SystemExit(f"{path}: holds no complete frame")
    return comment, rows


def read_packing(path, shear_rate=1.0):
    comment, rows = read_last_frame(path)
    lattice = [float(v) for v in re.search(r'Lattice="([^"]*)"', comment).group(1).split()]
    fields = re.search(r"Properties=(\S+)", comment).group(1).split(":")
    column, start = {}, 0
    for name, width in zip(fields[0::3], fields[2::3]):
        column[name] = slice(start, start + int(width))
        start += int(width)
    missing = {"pos", "radius", "velo"} - set(column)
    if missing:
        raise SystemExit(f"{path}: no column {', '.join(sorted(missing))}")

    def numbers(name):
        return np.array([row[column[name]] for row in rows], dtype=float)

    length = np.array([lattice[0], lattice[4], lattice[8]])
    if "angular_velocity" in column:
        angular_velocity = numbers("angular_velocity")
    else:
        angular_velocity = np.tile([0.0, 0.0, -0.5 * shear_rate], (len(rows), 1))
    velocity = numbers("velo")
    velocity[:, 0] += 0.5 * shear_rate * length[1]
    offset = lattice[3] - length[0] * round(lattice[3] / length[0])
    return Packing(length, offset, numbers("pos"), numbers("radius")[:, 0], velocity, angular_velocity)


def largest_overlap(packing):
    """Largest overlap of any pair over its sum of radii."""
    lx, ly, lz = packing.length
    largest = 0.0
    for i in range(len(packing.radius) - 1):
        x, y, z = (packing.position[i + 1:] - packing.position[i]).T
        up = np.round(y / ly)
        x = x - up * packing.offset
        distance = np.sqrt((x - lx * np.round(x / lx))**2 + (y - up * ly)**2 + (z - lz * np.round(z / lz))**2)
        largest = max(largest, np.max(1 - distance / (packing.radius[i + 1:] + packing.radius[i])))
    return largest


def write_lammps(path, packing, density):
    diameters, kind = np.unique(np.round(2 * packing.radius, 12), return_inverse=True)
    lx, ly, lz = packing.length
    with open(path, "w") as out:
        out.write(f"stresslet configuration\n\n{len(kind)} atoms\n{len(diameters)} atom types\n\n")
        out.write(f"0 {lx:.17g} xlo xhi\n0 {ly:.17g} ylo yhi\n0 {lz:.17g} zlo zhi\n{packing.offset:.17g} 0 0 xy xz yz\n\n")
        out.write("Atoms # sphere\n\n")
        for i, (k, x) in enumerate(zip(kind, packing.position), 1):
            out.write(f"{i} {k + 1} {diameters[k]:.12g} {density:.12g} {x[0]:.17g} {x[1]:.17g} {x[2]:.17g}\n")
        out.write("\nVelocities\n\n")
        for i, (u, w) in enumerate(zip(packing.velocity, packing.angular_velocity), 1):
            out.write(f"{i} " + " ".join(f"{v:.17g}" for v in (*u, *w)) + "\n")
    return diameters


def write_yade(path, packing):
    lx, ly, lz = packing.length
    table = np.column_stack([packing.position, packing.radius, packing.velocity, packing.angular_velocity])
    header = f"{lx:.17g} {ly:.17g} {lz:.17g} {packing.offset:.17g}\nLx Ly Lz offset above; x y z radius u v w wx wy wz"
    np.savetxt(path, table, fmt="%.17g", header=header)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packing", help="extended XYZ")
    parser.add_argument("prefix", help="the files PREFIX.lammps and PREFIX.yade are written")
    parser.add_argument("--density", type=float, default=0.1, help="particle density = Stokes number (default %(default)s)")
    arguments = parser.parse_args()
    packing = read_packing(arguments.packing)
    diameters = write_lammps(arguments.prefix + ".lammps", packing, arguments.density)
    write_yade(arguments.prefix + ".yade", packing)
    solid = np.sum(4 / 3 * np.pi * packing.radius**3) / np.prod(packing.length)
    overlap = largest_overlap(packing)
    if overlap > 0.0018:
        raise SystemExit(f"{arguments.packing}: overlap of {overlap:.3g} of the radii; Yade's start shrinks spheres by 0.002 only")
    print(f"{len(packing.radius)} particles, diameters {', '.join(f'{d:g}' for d in diameters)}, solid fraction {solid:.6f}, largest overlap {overlap:.2g} of the radii")


if __name__ == "__main__":
    main()
