"""The building: stage, proscenium, curtains, stalls, trusses and the housing of a lamp."""

import math

from kit.geometry import Part, box, lathe, place, rod
from theatre.plan import (BACKDROP, CEILING, OPENING_HALF, OPENING_HEIGHT, SEAT_ROWS, STAGE_BACK, STAGE_FRONT,
                          STAGE_HALF, STALLS_BACK, STALLS_FLOOR, TRUSS_HALF, TRUSS_HEIGHT, TRUSS_SIDE, TRUSSES,
                          WALL_THICKNESS)


def quad(name, material, corners, grain=None):
    part = Part(material)
    part.face(corners)
    part.place(name, grain=grain)


def build_shell(boards, black, plaster, cloth, carpet):
    s, f, b, c = STAGE_HALF, STAGE_FRONT, STAGE_BACK, CEILING
    quad("Stage floor", boards, ((-s, f, 0), (s, f, 0), (s, b, 0), (-s, b, 0)), grain=4.0)
    quad("Stage edge", black, ((-s, f, STALLS_FLOOR), (s, f, STALLS_FLOOR), (s, f, 0), (-s, f, 0)))
    quad("Backdrop", cloth, ((-s, BACKDROP, 0), (s, BACKDROP, 0), (s, BACKDROP, c), (-s, BACKDROP, c)))
    quad("Stage wall left", black, ((-s, f, 0), (-s, b, 0), (-s, b, c), (-s, f, c)))
    quad("Stage wall right", black, ((s, b, 0), (s, f, 0), (s, f, c), (s, b, c)))
    quad("Stage ceiling", black, ((-s, b, c), (s, b, c), (s, 0, c), (-s, 0, c)))

    z, y = STALLS_FLOOR, STALLS_BACK
    quad("Stalls floor", carpet, ((-s, y, z), (s, y, z), (s, f, z), (-s, f, z)))
    quad("Stalls wall left", plaster, ((-s, y, z), (-s, f, z), (-s, f, c), (-s, y, c)))
    quad("Stalls wall right", plaster, ((s, f, z), (s, y, z), (s, y, c), (s, f, c)))
    quad("Stalls wall back", plaster, ((s, y, z), (-s, y, z), (-s, y, c), (s, y, c)))
    quad("Stalls ceiling", plaster, ((-s, 0, c), (s, 0, c), (s, y, c), (-s, y, c)))


def build_proscenium(plaster, gold):
    w, h, t = OPENING_HALF, OPENING_HEIGHT, WALL_THICKNESS
    part = Part(plaster)
    box(part, (-STAGE_HALF, -t, 0), (-w, 0, CEILING))
    box(part, (w, -t, 0), (STAGE_HALF, 0, CEILING))
    box(part, (-w, -t, h), (w, 0, CEILING))
    part.place("Proscenium")
    frame = Part(gold)
    for deep, wide in ((0.22, 0.10), (0.12, 0.34)):
        for side in (-1, 1):
            x = sorted((side * w, side * (w + wide)))
            box(frame, (x[0], -t - deep, 0), (x[1], -t, h + wide))
        box(frame, (-w, -t - deep, h), (w, -t, h + wide))
    frame.place("Gilded frame")


def curtain(name, velvet, x_range, y, z_range, folds, depth):
    """A curtain in folds, visible from both sides."""
    part = Part(velvet)
    steps = 6 * folds
    (x0, x1), (z0, z1) = x_range, z_range
    rows = [[(x0 + (x1 - x0) * i / steps, y + depth * math.sin(2 * math.pi * i / 6), z) for i in range(steps + 1)]
            for z in (z0, z1)]
    part.grid(rows)
    part.grid([list(reversed(row)) for row in rows])
    part.place(name, smooth_below=70)


def build_curtains(velvet, black):
    w, h = OPENING_HALF, OPENING_HEIGHT
    curtain("Curtain left", velvet, (-w - 0.6, -w + 1.0), 0.35, (0, h + 0.4), 9, 0.09)
    curtain("Curtain right", velvet, (w - 1.0, w + 0.6), 0.35, (0, h + 0.4), 9, 0.09)
    curtain("Pelmet", velvet, (-w, w), 0.2, (h - 0.7, h + 0.4), 40, 0.06)
    for i, y in enumerate((3.4, 7.2)):  # legs: they hide the wings
        curtain(f"Leg left {i + 1}", black, (-9.0, -7.6), y, (0, 8.4), 5, 0.07)
        curtain(f"Leg right {i + 1}", black, (7.6, 9.0), y, (0, 8.4), 5, 0.07)


def build_seats(plush):
    part = Part(plush)
    for i in range(20):
        x = -5.7 + 0.6 * i
        box(part, (x - 0.26, -0.06, 0.0), (x + 0.26, 0.06, 0.92))
        lathe(part, [(0.0, 0.92), (0.2, 0.94), (0.16, 1.0), (0.0, 1.03)], 8, (x, 0.0))
    mesh = part.mesh("Row of seats")
    for i, y in enumerate(SEAT_ROWS):
        place(f"Row {i + 1}", mesh, (0, y, STALLS_FLOOR))


def build_trusses(steel):
    part = Part(steel)
    half, side, bays = TRUSS_HALF, TRUSS_SIDE / 2, 20
    corners = [(-side, -side), (side, -side), (side, side), (-side, side)]
    for y, z in corners:
        rod(part, (-half, y, z), (half, y, z), 0.025, 0.025, 4)
    for bay in range(bays):
        x0, x1 = (-half + 2 * half * (bay + k) / bays for k in (0, 1))
        for k in range(4):
            a, b = corners[k], corners[(k + 1) % 4]
            if (bay + k) % 2:
                a, b = b, a
            rod(part, (x0, *a), (x1, *b), 0.012, 0.012, 3)
    mesh = part.mesh("Truss")
    for i, y in enumerate(TRUSSES):
        place(f"Truss {i + 1}", mesh, (0, y, TRUSS_HEIGHT))


def lamp_housing(steel, glow):
    """The housing, behind the lens at the origin; the lamp looks along -Z."""
    part = Part(steel, glow)
    lathe(part, [(0.10, 0.0), (0.10, 0.26), (0.15, 0.34), (0.15, 0.56), (0.06, 0.64), (0.0, 0.64)], 12)
    lathe(part, [(0.0, 0.02), (0.10, 0.02)], 12, slot=1)
    box(part, (-0.19, 0.10, 0.40), (-0.16, 0.16, 0.50))
    box(part, (0.16, 0.10, 0.40), (0.19, 0.16, 0.50))
    return part.mesh("Lamp housing", smooth_below=40)
