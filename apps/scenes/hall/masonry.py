"""The hall itself: floor, walls, windows, arcade, ceiling."""

import math

from kit.geometry import Part, arch, bar, box, lathe, pierced_wall, place, tile
from hall.plan import (ARCADE, BACK, BAY_HALF, COLUMN_TOP, COLUMNS, FRONT, HEIGHT, NAVE_WALL, PANE_HEIGHT, SILL,
                       TRACERY, WALL_THICKNESS, WINDOW_ARCH, WINDOW_HALF, WINDOW_SPRING, WINDOW_WALL, WINDOWS)


def courses(part, y_range, z_range, size, openings, to_world, across, up, slots):
    """Ashlar in running bond, without `openings` (low y, high y, low z, high z)."""
    (y0, y1), (z0, z1) = y_range, z_range
    length, height = size
    for row in range(round((z1 - z0) / height)):
        z = z0 + row * height
        taken = sorted((a, b) for a, b, low, high in openings if low < z + height - 0.01 and high > z + 0.01)
        free, at = [], y0
        for a, b in taken:
            free.append((at, a))
            at = b
        free.append((at, y1))
        for a, b in free:
            edge = y0 - (row % 2) * length / 2
            count = 0
            while edge < b:
                low, high = max(a, edge), min(b, edge + length)
                if high - low > 0.08:
                    slot = slots[(row * 7 + count * 5 + (row * count) % 3) % len(slots)]
                    tile(part, to_world(low, z), across, up, (high - low, height), 0.025, slot)
                edge += length
                count += 1


def build_floor(pale, dark):
    part = Part(pale, dark)
    side = 1.05
    for i in range(math.ceil((NAVE_WALL - WINDOW_WALL) / side)):
        for j in range(math.ceil((BACK - FRONT) / side)):
            tile(part, (WINDOW_WALL + i * side, FRONT + j * side, -0.012), (1, 0, 0), (0, 1, 0), (side, side), 0.012,
                 (i + j) % 2)
    part.place("Floor", grain=1.7)


def build_walls(stone, pale, shade):
    openings = [(y, SILL, WINDOW_SPRING, WINDOW_ARCH) for y in WINDOWS]
    wall = Part(stone, pale, shade)
    pierced_wall(wall, (WINDOW_WALL - WALL_THICKNESS, WINDOW_WALL), (FRONT, BACK), (-0.2, HEIGHT), openings, 0, 1)
    margin = 0.28
    rise = max(r for _, r in WINDOW_ARCH)
    courses(wall, (FRONT, BACK), (0.0, HEIGHT), (1.2, 0.5),
            [(y - WINDOW_HALF - margin, y + WINDOW_HALF + margin, SILL - 0.35, WINDOW_SPRING + rise + margin)
             for y in WINDOWS],
            lambda y, z: (WINDOW_WALL, y, z), (0, 1, 0), (0, 0, 1), (0, 0, 2))
    wall.place("Window wall", grain=2.3)

    surround = Part(pale)
    outline = [(u * 1.13, WINDOW_SPRING + r * 1.13) for u, r in WINDOW_ARCH]
    bar(surround, [(outline[0][0], SILL)] + outline + [(outline[-1][0], SILL)], 0.26, 0.16, 0, 0.05)
    box(surround, (-0.3, -WINDOW_HALF - 0.28, SILL - 0.25), (0.16, WINDOW_HALF + 0.28, SILL))
    mesh = surround.mesh("Window surround", grain=1.3)
    for i, y in enumerate(WINDOWS):
        place(f"Window surround {i + 1}", mesh, (WINDOW_WALL, y, 0))

    shell = Part(stone, shade)
    x0, x1 = WINDOW_WALL, NAVE_WALL
    courses(shell, (0, x1 - x0), (0.0, HEIGHT), (1.2, 0.5), [], lambda u, z: (x0 + u, BACK, z), (1, 0, 0), (0, 0, 1),
            (0, 0, 1))
    shell.face(((x0, BACK, 0), (x1, BACK, 0), (x1, BACK, HEIGHT), (x0, BACK, HEIGHT)))
    shell.face(((x1, FRONT, 0), (x0, FRONT, 0), (x0, FRONT, HEIGHT), (x1, FRONT, HEIGHT)))
    shell.face(((x1, BACK, 0), (x1, FRONT, 0), (x1, FRONT, HEIGHT), (x1, BACK, HEIGHT)))
    shell.place("Hall walls", grain=2.3)


def build_ceiling(plaster, wood):
    part = Part(plaster, wood)
    thick = 0.3
    box(part, (WINDOW_WALL - WALL_THICKNESS, FRONT, HEIGHT), (NAVE_WALL, BACK, HEIGHT + thick), 0)
    for k in range(11):
        y = FRONT + 1 + k * 2.0
        box(part, (ARCADE, y - 0.16, HEIGHT - 0.42), (NAVE_WALL, y + 0.16, HEIGHT), 1)
        box(part, (WINDOW_WALL, y - 0.12, HEIGHT - 0.3), (ARCADE, y + 0.12, HEIGHT), 1)
    part.place("Ceiling", grain=2.3)


def build_arcade(stone, pale):
    points = arch(BAY_HALF, 0.5, 10)
    bays = [((a + b) / 2, COLUMN_TOP, COLUMN_TOP, points) for a, b in zip(COLUMNS, COLUMNS[1:])]
    wall = Part(stone, pale)
    pierced_wall(wall, (ARCADE - 0.34, ARCADE + 0.34), (FRONT, BACK), (COLUMN_TOP, HEIGHT), bays, 0, 1)
    edges = [FRONT] + [c + s * BAY_HALF for c, _, _, _ in bays for s in (-1, 1)] + [BACK]
    for a, b in zip(edges[::2], edges[1::2]):
        wall.face([(ARCADE + sx * 0.34, y, COLUMN_TOP) for sx, y in ((-1, a), (-1, b), (1, b), (1, a))])
    wall.place("Arcade", grain=2.3)
    moulding = Part(pale)
    for side in (-1, 1):
        bar(moulding, [(u * 1.06, COLUMN_TOP + r * 1.06) for u, r in points], 0.16, 0.12, side * 0.34, 0.04)
    mesh = moulding.mesh("Arch moulding", grain=1.3)
    for i, (centre, _, _, _) in enumerate(bays):
        place(f"Arch moulding {i + 1}", mesh, (ARCADE, centre, 0))


def build_columns(pale):
    part = Part(pale)
    box(part, (-0.55, -0.55, 0.0), (0.55, 0.55, 0.22))
    attic_base = [(0.54, 0.22), (0.55, 0.27), (0.54, 0.32), (0.47, 0.345), (0.455, 0.39), (0.48, 0.42), (0.495, 0.45),
                  (0.48, 0.48), (0.42, 0.50)]
    shaft = []
    for drum in range(4):
        low, high = 0.52 + drum * 0.8, 0.52 + (drum + 1) * 0.8
        taper = 0.4 - 0.012 * drum
        shaft += [(taper - 0.012, low), (taper, low + 0.02), (taper - 0.01, high - 0.02), (taper - 0.022, high)]
    capital = [(0.37, 3.75), (0.42, 3.78), (0.43, 3.81), (0.40, 3.84), (0.375, 3.88), (0.39, 4.0), (0.43, 4.1),
               (0.5, 4.18), (0.52, 4.2)]
    lathe(part, attic_base + shaft + capital, 32)
    box(part, (-0.54, -0.54, 4.2), (0.54, 0.54, COLUMN_TOP))
    mesh = part.mesh("Column", smooth_below=40, grain=1.256, turned=True)
    for i, y in enumerate(COLUMNS):
        place(f"Column {i + 1}", mesh, (ARCADE, y, 0))


def build_tracery(lead):
    part = Part(lead)
    outline = [(u, WINDOW_SPRING + r) for u, r in WINDOW_ARCH]
    bar(part, [(-WINDOW_HALF, SILL)] + outline + [(WINDOW_HALF, SILL)], 0.14, 0.16, 0, 0.03)
    bar(part, [(0, SILL), (0, WINDOW_SPRING + 0.35)], 0.13, 0.16, 0, 0.03)
    for row in range(1, math.ceil((WINDOW_SPRING - SILL) / PANE_HEIGHT)):
        z = SILL + row * PANE_HEIGHT
        bar(part, [(-WINDOW_HALF, z), (WINDOW_HALF, z)], 0.1, 0.12, 0, 0.025)
    half = WINDOW_HALF / 2
    for side in (-1, 1):
        bar(part, [(side * half + u, WINDOW_SPRING + r) for u, r in arch(half, 0.3, 6)], 0.1, 0.14, 0, 0.025)
    oculus = [(0.28 * math.cos(a), WINDOW_SPRING + 0.72 + 0.28 * math.sin(a))
              for a in (2 * math.pi * i / 20 for i in range(20))]
    bar(part, oculus, 0.09, 0.14, 0, 0.025, closed=True)
    mesh = part.mesh("Tracery", smooth_below=30)
    for i, y in enumerate(WINDOWS):
        place(f"Tracery {i + 1}", mesh, (TRACERY, y, 0))
