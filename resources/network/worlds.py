#!/usr/bin/env python3
"""Draws a world for the network of masks from a seed: the options of `ostraka rig simulate`.

    worlds.py SEED THINGS_FOLDER

prints them in one line. Four of ten worlds are photographs by hand over a sheet, the others a rig's,
most on grey, light and white plates; in one of four lie things of any shape in place of sherds
(THINGS_FOLDER/*.ply).
"""
import math
import random
import sys

import numpy as np


def icosphere(subdivisions):
    """Vertices (n, 3) on the unit sphere and faces (m, 3), counter-clockwise from outside."""
    g = (1 + math.sqrt(5)) / 2
    vertices = [np.array(v, float) / math.hypot(1, g) for v in [
        (-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
        (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
             (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
             (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(subdivisions):
        middle = {}

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                m = vertices[a] + vertices[b]
                vertices.append(m / np.linalg.norm(m))
                middle[key] = len(vertices) - 1
            return middle[key]

        faces = [t for a, b, c in faces for ab, bc, ca in [(between(a, b), between(b, c), between(c, a))]
                 for t in [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]]
    return np.array(vertices), np.array(faces)


def thing(draw):
    """A stone, box, can, fruit or lump: a superellipsoid with bumps, 12 to 75 mm across, mm."""
    unit, faces = icosphere(4)
    half = np.array([math.exp(draw.uniform(math.log(6), math.log(37))) for _ in range(3)])
    half = np.clip(half, half.max() / 4, None)
    power = draw.choice([1.4, 2, 2, 2.5, 4, 8, 16])
    radius = (np.abs(unit) ** power).sum(axis=1) ** (-1 / power)
    bumps = draw.choice([0, 0, 0.05, 0.12, 0.2]) if power < 4 else draw.choice([0, 0, 0.02])
    for _ in range(8):
        wave = np.array([draw.gauss(0, 1) for _ in range(3)]) * draw.uniform(1, 5)
        radius += bumps / 3 * np.sin(unit @ wave + draw.uniform(0, 2 * math.pi))
    return unit * radius[:, None] * half, faces


def write_ply(path, vertices, faces):
    with open(path, "w") as file:
        file.write("ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
                   "property float z\nelement face %d\nproperty list uchar int vertex_indices\n"
                   "end_header\n" % (len(vertices), len(faces)))
        file.writelines("%.4f %.4f %.4f\n" % tuple(v) for v in vertices)
        file.writelines("3 %d %d %d\n" % tuple(f) for f in faces)


def options(seed, things_folder):
    draw = random.Random(seed)
    words = ["--seed", seed]
    if draw.random() < 0.42:
        words += ["--hand-held", 4, "--width", draw.choice([896, 1024, 1280])]
        words += ["--sheet", draw.choice("a4 a4 a4 a3 letter".split())]
        words += ["--table", draw.choice("wood cloth granite cutting-mat".split())]
        words += ["--light", draw.choice("window lamp flash overcast sun".split())]
        words += ["--camera", draw.choice("phone phone dslr compact".split())]
        words += ["--clutter", draw.choice([0, 2, 3, 4]), "--bend", draw.choice([0, 0, 2, 4])]
        most, things = 8, 0.35
    else:
        words += ["--stops", 2, "--width", draw.choice([1024, 1024, 1280, 1600])]
        words += ["--plate", draw.choice("dark dark dark mid mid mid mid mid mid light light light "
                                         "light light light white white white white white".split())]
        if draw.random() < 0.6:
            words += ["--fstop", draw.choice([5.6, 8, 11])]
        most, things = 14, 0.15
    words += ["--gloss", draw.choice([0, 0.3, 0.5, 0.5, 0.8])]
    if draw.random() < things:
        for i in range(draw.randint(1, 4)):
            path = "%s/%d_%d.ply" % (things_folder, seed, i)
            write_ply(path, *thing(draw))
            words += ["--mesh", path]
    else:
        words += ["--sherds", draw.randint(4, most)]
        if draw.random() < 0.3:
            words.append("--plain")
        if most > 8 and draw.random() < 0.4:
            words += ["--touching", draw.randint(1, 2)]
    return words


if __name__ == "__main__":
    print(*options(int(sys.argv[1]), sys.argv[2]))
