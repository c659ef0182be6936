"""Objects in the streets: lamp posts, signs, cars, trees; and the ground."""

import math

import numpy

from kit.geometry import Part, box, lathe, place, rod
from town.plan import (BACKS, CAR_LINE, CARS, CROSSING, EDGE, END, FRONTS, KERB, LANE_INNER, LANE_OUTER, POST_HEIGHT,
                       POST_ARM, SQUARE, START, TREE_LINE, TREES)


def build_ground(asphalt, paving, grass):
    """All in one plane, side by side."""
    def strip(name, material, x_range, y_range, grain):
        part = Part(material)
        (x0, x1), (y0, y1) = x_range, y_range
        part.face(((x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0)))
        part.place(name, grain=grain)

    a, b = CROSSING
    strip("Cross street", asphalt, (-EDGE, EDGE), (a, b), 6.0)
    strip("Square", paving, (-EDGE, EDGE), (SQUARE[0], END), 4.0)
    for part_of_town, span in (("south", (START, a)), ("north", (b, SQUARE[0]))):
        strip(f"Carriageway {part_of_town}", asphalt, (-KERB, KERB), span, 6.0)
        for side, name in ((-1, "left"), (1, "right")):
            def mirrored(low, high, side=side):
                return (low, high) if side > 0 else (-high, -low)
            strip(f"Pavement {name} {part_of_town}", paving, mirrored(KERB, FRONTS), span, 2.0)
            strip(f"Gardens {name} {part_of_town}", grass, mirrored(FRONTS, LANE_INNER), span, 5.0)
            strip(f"Lane {name} {part_of_town}", asphalt, mirrored(LANE_INNER, LANE_OUTER), span, 6.0)
            strip(f"Yards {name} {part_of_town}", paving, mirrored(LANE_OUTER, EDGE), span, 4.0)
    assert BACKS < LANE_INNER


def lamp_post(iron, glow):
    """Its lamp's head hangs at the origin, over +x of its foot; no part of the post is in front of the lamp."""
    part = Part(iron, glow)
    arm, height = POST_ARM, POST_HEIGHT
    rod(part, (-arm, 0, -height), (-arm, 0, -0.2), 0.09, 0.05, 6)
    rod(part, (-arm, 0, -0.2), (-arm + 0.5, 0, 0.22), 0.05, 0.04, 6)
    rod(part, (-arm + 0.5, 0, 0.22), (0.1, 0, 0.2), 0.04, 0.03, 6)
    box(part, (-0.35, -0.12, 0.09), (0.22, 0.12, 0.2))
    part.face(((-0.3, -0.1, 0.085), (-0.3, 0.1, 0.085), (0.18, 0.1, 0.085), (0.18, -0.1, 0.085)), 1)
    return part.mesh("Lamp post")


def sign(colour_name, glow, iron):
    """A blade that projects from a front along +x; its lower end is the origin."""
    part = Part(iron, glow)
    box(part, (-0.28, -0.09, 0.06), (0.28, 0.09, 1.86))
    for side in (-1, 1):
        y = side * 0.1
        for low, high in ((0.16, 0.66), (0.74, 1.2), (1.28, 1.76)):
            corners = [(-0.2, y, low), (0.2, y, low), (0.2, y, high), (-0.2, y, high)]
            part.face(corners if side < 0 else reversed(corners), 1)
    rod(part, (-0.75, 0, 0.5), (-0.28, 0, 0.5), 0.03, 0.03, 4)
    rod(part, (-0.75, 0, 1.5), (-0.28, 0, 1.5), 0.03, 0.03, 4)
    return part.mesh(f"Sign, {colour_name}")


def build_cars(paints, glass, rubber):
    outline = ((-2.1, 0.30), (2.1, 0.30), (2.15, 0.62), (1.95, 0.82), (1.05, 0.92), (0.45, 1.40), (-1.1, 1.42),
               (-1.75, 0.98), (-2.1, 0.86))
    meshes = []
    for i, paint in enumerate(paints):
        part = Part(paint, glass, rubber)
        for side in (-1, 1):
            points = [(side * 0.86, y, z) for y, z in outline]
            part.face(points if side > 0 else reversed(points))
            window = [(side * 0.87, y, z) for y, z in ((-1.5, 0.98), (0.9, 0.96), (0.42, 1.32), (-1.05, 1.34))]
            part.face(window if side > 0 else reversed(window), 1)
            for y in (-1.35, 1.35):
                disc = [(side * 0.88, y + 0.33 * math.cos(a), 0.33 + 0.33 * math.sin(a))
                        for a in (2 * math.pi * k / 12 for k in range(12))]
                part.face(disc if side > 0 else reversed(disc), 2)
        for k, (a, b) in enumerate(zip(outline, outline[1:] + outline[:1])):
            part.face(((0.86, *a), (-0.86, *a), (-0.86, *b), (0.86, *b)), 1 if k in (4, 6) else 0)
        meshes.append(part.mesh(f"Car {i + 1}"))
    for i, (side, y) in enumerate(CARS):
        place(f"Parked car {i + 1}", meshes[i % len(meshes)], (side * CAR_LINE, y, 0), (0, 0, math.pi * (side < 0)))


def build_trees(bark, foliage):
    random = numpy.random.RandomState(12)
    part = Part(bark, foliage)
    rod(part, (0, 0, 0), (0, 0, 2.4), 0.13, 0.09, 7)
    rows = []
    for ring in range(7):
        tilt = math.pi * ring / 6
        rows.append([(math.sin(tilt) * r * math.cos(a), math.sin(tilt) * r * math.sin(a), 3.3 - 1.25 * math.cos(tilt))
                     for a, r in ((2 * math.pi * k / 9, 1.25 * (0.8 + 0.4 * random.random_sample()))
                                  for k in range(9))])
    part.grid(rows, 1, closed=True)
    mesh = part.mesh("Tree")
    for i, (side, y) in enumerate(TREES):
        place(f"Tree {i + 1}", mesh, (side * TREE_LINE, y, 0), (0, 0, 1.3 * i))
