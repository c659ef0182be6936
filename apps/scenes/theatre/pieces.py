"""Objects on the stage: stair, gate, tree and dancers. Only some of the beams meet them."""

import math

from mathutils import Vector

from kit.geometry import Part, arch, bar, box, lathe, place, rod
from theatre.plan import FIGURES, GATE, STAIR, TREE


def build_stair(paint):
    part = Part(paint)
    for step in range(3):
        radius, z = 2.1 - 0.45 * step, 0.2 * step
        lathe(part, [(radius, z), (radius, z + 0.2), (0.0, z + 0.2)], 32, STAIR)
    part.place("Stair", smooth_below=40)


def build_gate(paint):
    half, spring, points = 0.9, 2.1, arch(0.9, 0.0, 8)
    path = [(-half, 0.0)] + [(u, spring + r) for u, r in points] + [(half, 0.0)]
    part = Part(paint)
    bar(part, path, 0.34, 0.5, 0.0, 0.06)
    for side in (-half, half):
        box(part, (-0.32, side - 0.26, 0.0), (0.32, side + 0.26, 0.25))
    place("Gate", part.mesh("Gate"), (*GATE, 0), (0, 0, math.radians(62)))


def build_tree(bark):
    """Bare branches: each forks in three, turned about the stem and tilted from it."""
    part = Part(bark)

    def grow(foot, direction, length, radius, depth, turn):
        tip = foot + direction * length
        rod(part, foot, tip, radius, 0.68 * radius, 6 if depth > 2 else 4)
        if depth == 0:
            return
        side = direction.orthogonal().normalized()
        for k in range(3):
            around = turn + 2 * math.pi * k / 3
            lean = math.radians(26 + 9 * ((k + depth) % 3))
            out = side * math.cos(around) + direction.cross(side) * math.sin(around)
            grow(tip, (direction * math.cos(lean) + out * math.sin(lean)).normalized(), length * (0.78 - 0.06 * k),
                 0.66 * radius, depth - 1, turn + 0.9)

    grow(Vector((*TREE, 0.0)), Vector((-0.08, 0.0, 1.0)).normalized(), 1.15, 0.14, 4, 0.4)
    part.place("Tree")


def build_figures(cloth, skin):
    part = Part(cloth, skin)
    lathe(part, [(0.52, 0.02), (0.44, 0.30), (0.30, 0.66), (0.17, 0.98), (0.13, 1.08), (0.17, 1.24), (0.18, 1.36),
                 (0.10, 1.45), (0.0, 1.47)], 14)
    lathe(part, [(0.055, 1.44), (0.05, 1.52)], 8, slot=1)
    lathe(part, [(0.0, 1.50), (0.07, 1.53), (0.10, 1.62), (0.085, 1.70), (0.0, 1.75)], 10, slot=1)
    for side, elbow, hand in ((-1, (0.46, 0.10, 1.52), (0.54, 0.02, 1.84)), (1, (0.45, -0.12, 1.26), (0.74, -0.2, 1.42))):
        shoulder = (side * 0.17, 0.0, 1.36)
        elbow, hand = ((side * p[0], p[1], p[2]) for p in (elbow, hand))
        rod(part, shoulder, elbow, 0.05, 0.04, 6, slot=1)
        rod(part, elbow, hand, 0.04, 0.025, 6, slot=1)
    mesh = part.mesh("Dancer", smooth_below=60)
    for i, (x, y, z, turn) in enumerate(FIGURES):
        place(f"Dancer {i + 1}", mesh, (x, y, z), (0, 0, turn))
