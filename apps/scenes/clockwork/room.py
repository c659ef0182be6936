"""The room in the tower: floor, walls with the round opening, the chamber behind it, and a workbench."""

import math

from clockwork.plan import (CHAMBER_BACK, OPENING, OPENING_RADIUS, PENDANT, ROOM_FRONT, ROOM_HALF, ROOM_HEIGHT,
                            WALL_THICKNESS)
from kit.geometry import Part, box, lathe, place, rod


def quad(name, material, corners, grain=2.0):
    part = Part(material)
    part.face(corners)
    part.place(name, grain=grain)


def build_shell(floor, stone, soot):
    w, f, h, b = ROOM_HALF, ROOM_FRONT, ROOM_HEIGHT, CHAMBER_BACK
    quad("Floor", floor, ((-w, f, 0), (w, f, 0), (w, b, 0), (-w, b, 0)))
    quad("Wall left", stone, ((-w, f, 0), (-w, b, 0), (-w, b, h), (-w, f, h)))
    quad("Wall right", stone, ((w, b, 0), (w, f, 0), (w, f, h), (w, b, h)))
    quad("Wall behind the viewer", stone, ((w, f, 0), (-w, f, 0), (-w, f, h), (w, f, h)))
    quad("Chamber wall", soot, ((-w, b, 0), (w, b, 0), (w, b, h), (-w, b, h)))
    quad("Ceiling", soot, ((-w, b, h), (w, b, h), (w, f, h), (-w, f, h)))


def build_pierced_wall(stone, trim):
    """Both faces run from the circle to the wall's edge in the same number of steps; each corner is on a step."""
    steps, (cx, cz), r, t = 48, OPENING, OPENING_RADIUS, WALL_THICKNESS
    edges = (-ROOM_HALF, 0.0), (ROOM_HALF, ROOM_HEIGHT)
    corners = sorted(math.atan2(z - cz, x - cx) for x in (-ROOM_HALF, ROOM_HALF) for z in (0.0, ROOM_HEIGHT))
    angles = [2 * math.pi * i / steps - math.pi for i in range(steps)]
    for corner in corners:
        nearest = min(range(steps), key=lambda i: abs(angles[i] - corner))
        angles[nearest] = corner
    circle = [(cx + r * math.cos(a), cz + r * math.sin(a)) for a in angles]
    border = []
    for a in angles:
        c, s = math.cos(a), math.sin(a)
        distance = min(((edges[c > 0][0] - cx) / c) if abs(c) > 1e-9 else math.inf,
                    ((edges[s > 0][1] - cz) / s) if abs(s) > 1e-9 else math.inf)
        border.append((cx + distance * c, cz + distance * s))

    part = Part(stone)
    for outer, inner, y in ((border, circle, 0.0), (circle, border, t)):
        part.grid([[(x, y, z) for x, z in outer], [(x, y, z) for x, z in inner]], closed=True)
    part.grid([[(x, 0.0, z) for x, z in circle], [(x, t, z) for x, z in circle]], closed=True)
    part.place("Pierced wall", grain=2.0)

    ring = Part(trim)
    for wide, deep, narrow in ((0.42, 0.08, 0.0), (0.16, 0.14, 0.0)):
        def circle_at(radius, y):
            return [(cx + radius * math.cos(a), y, cz + radius * math.sin(a)) for a in angles]
        ring.grid([circle_at(r + wide, 0.0), circle_at(r + wide, -deep), circle_at(r + narrow, -deep),
                   circle_at(r + narrow, 0.0)], closed=True)
    ring.place("Ring of stones", smooth_below=30, grain=1.0)


def build_furniture(wood, iron, glow):
    bench = Part(wood, iron)
    box(bench, (-1.1, -0.4, 0.86), (1.1, 0.4, 0.94))
    for x in (-1.0, 1.0):
        for y in (-0.32, 0.32):
            box(bench, (x - 0.05, y - 0.05, 0.0), (x + 0.05, y + 0.05, 0.86))
    box(bench, (-0.6, -0.2, 0.94), (-0.1, 0.15, 1.16), 1)
    lathe(bench, [(0.16, 0.94), (0.14, 1.02), (0.05, 1.06), (0.05, 1.24), (0.0, 1.26)], 12, (0.5, 0.05), 1)
    place("Workbench", bench.mesh("Workbench"), (5.2, -2.0, 0.0), (0, 0, math.radians(90)))

    stool = Part(wood)
    lathe(stool, [(0.2, 0.56), (0.2, 0.62), (0.0, 0.62)], 16)
    for i in range(3):
        a = 2 * math.pi * i / 3
        rod(stool, (0.12 * math.cos(a), 0.12 * math.sin(a), 0.57), (0.22 * math.cos(a), 0.22 * math.sin(a), 0.0),
            0.025, 0.02, 6)
    place("Stool", stool.mesh("Stool", smooth_below=40), (2.1, -3.4, 0.0))

    x, y, z = PENDANT
    shade = Part(iron, glow)
    lathe(shade, [(0.34, 0.0), (0.10, 0.2), (0.03, 0.26), (0.012, 0.3), (0.012, ROOM_HEIGHT - z)], 20)
    lathe(shade, [(0.0, 0.04), (0.07, 0.06), (0.06, 0.14), (0.0, 0.18)], 12, slot=1)
    place("Pendant lamp", shade.mesh("Pendant lamp", smooth_below=40), (x, y, z))
