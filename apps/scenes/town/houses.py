"""Houses in four kinds, and the town hall. A house's front is in the plane x = 0 and faces +x."""

import math

from kit.geometry import Part, box, place
from town.plan import FRONTS, HOUSE_DEPTH, HOUSE_WIDTH, HOUSES, TOWN_HALL

PROUD = 0.02  # metres from the wall to its panes


def pane(part, y, z, wide, high, slot, front=True):
    x = PROUD if front else -HOUSE_DEPTH - PROUD
    corners = [(x, y - wide / 2, z), (x, y + wide / 2, z), (x, y + wide / 2, z + high), (x, y - wide / 2, z + high)]
    part.face(corners if front else reversed(corners), slot)


def house(kind, wall, roof, dark, lit):
    """Slots: wall, roof, dark panes and doors, lit panes. Which panes are lit follows from the kind."""
    floors, ridge = (2, 3, 3, 2)[kind], (2.6, 2.0, 2.9, 2.2)[kind]
    half, eaves = HOUSE_WIDTH / 2, 3.2 * floors + 0.5
    part = Part(wall, roof, dark, lit)
    for face in (((0, -half, 0), (0, half, 0), (0, half, eaves), (0, -half, eaves)),
                 ((-HOUSE_DEPTH, half, 0), (-HOUSE_DEPTH, -half, 0), (-HOUSE_DEPTH, -half, eaves),
                  (-HOUSE_DEPTH, half, eaves))):
        part.face(face)
    middle, top, over = -HOUSE_DEPTH / 2, eaves + ridge, 0.3
    for side in (-1, 1):
        gable = [(0, side * half, 0), (0, side * half, eaves), (middle, side * half, top),
                 (-HOUSE_DEPTH, side * half, eaves), (-HOUSE_DEPTH, side * half, 0)]
        part.face(reversed(gable) if side > 0 else gable)
    drop = over * ridge / (HOUSE_DEPTH / 2)
    part.face(((over, -half, eaves - drop), (over, half, eaves - drop), (middle, half, top), (middle, -half, top)), 1)
    part.face(((-HOUSE_DEPTH - over, half, eaves - drop), (-HOUSE_DEPTH - over, -half, eaves - drop),
               (middle, -half, top), (middle, half, top)), 1)
    part.face(((over, half, eaves - drop), (over, -half, eaves - drop), (-HOUSE_DEPTH - over, -half, eaves - drop),
               (-HOUSE_DEPTH - over, half, eaves - drop)), 1)
    box(part, (middle - 1.2, -0.6 * half, top - 0.8), (middle - 0.5, -0.6 * half + 0.7, top + 0.9))

    pane(part, -2.0, 0.0, 1.1, 2.2, 2)  # the door, under its lamp
    pane(part, 3.0, 0.6, 4.6, 1.9, 3 if kind in (1, 2) else 2)  # a shop's window
    pane(part, -5.0, 0.9, 1.4, 1.4, 2)
    for floor in range(1, floors):
        for i, y in enumerate((-5.0, -2.0, 1.0, 4.6)):
            pane(part, y, 3.2 * floor + 0.9, 1.1, 1.5, 3 if (2 * i + 3 * floor + kind) % 5 == 0 else 2)
    for floor in range(floors):
        for i, y in enumerate((-4.5, 0.0, 4.5)):
            pane(part, y, 3.2 * floor + 0.9, 1.1, 1.3, 3 if (i + 2 * floor + kind) % 6 == 0 else 2, front=False)
    return part.mesh(f"House of kind {kind + 1}")


def kind_of(index, side):
    return (3 * index + (side > 0) + index // 4) % 4


def pose_of(side, y):
    """Position and rotation of a house on the left (-1) or right (1) side of the street."""
    return (side * FRONTS, y, 0.0), (0.0, 0.0, 0.0 if side < 0 else math.pi)


def build_houses(walls, roof, dark, lit):
    kinds = [house(kind, walls[kind], roof, dark, lit) for kind in range(4)]
    for side, name in ((-1, "left"), (1, "right")):
        for i, y in enumerate(HOUSES):
            place(f"House {name} {i + 1}", kinds[kind_of(i, side)], *pose_of(side, y))


def build_town_hall(wall, roof, dark, lit):
    part = Part(wall, roof, dark, lit)
    box(part, (-18, TOWN_HALL, 0), (18, TOWN_HALL + 10, 12))
    box(part, (-3.5, TOWN_HALL - 1.2, 0), (3.5, TOWN_HALL, 24))
    peak = (0, TOWN_HALL - 0.6 + 2.5, 31)
    base = [(-3.8, TOWN_HALL - 1.5, 24), (3.8, TOWN_HALL - 1.5, 24), (3.8, TOWN_HALL + 5.0, 24),
            (-3.8, TOWN_HALL + 5.0, 24)]
    for i in range(4):
        part.face((base[i], base[(i + 1) % 4], peak), 1)
    y = TOWN_HALL - PROUD
    for row in range(3):
        for i in range(10):
            x = (-1 if i < 5 else 1) * (5.6 + 2.6 * (i % 5))
            slot = 3 if (3 * i + 2 * row) % 4 == 0 else 2
            part.face(((x - 0.6, y, 1.2 + 3.6 * row), (x + 0.6, y, 1.2 + 3.6 * row), (x + 0.6, y, 3.2 + 3.6 * row),
                       (x - 0.6, y, 3.2 + 3.6 * row)), slot)
    clock = [(1.5 * math.cos(2 * math.pi * k / 16), TOWN_HALL - 1.2 - PROUD, 20 + 1.5 * math.sin(2 * math.pi * k / 16))
             for k in range(16)]
    part.face(clock, 3)
    part.place("Town hall")
