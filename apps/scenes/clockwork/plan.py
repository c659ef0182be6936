"""Layout of the clock tower. Metres; x across, y from the room to the lamp behind the wheels, z up."""

import math

# The room with the shafts is at y < 0, the lamp's chamber is behind the wall with the opening.
ROOM_HALF, ROOM_FRONT, ROOM_HEIGHT = 7.0, -10.0, 7.0
WALL_THICKNESS = 0.4
CHAMBER_BACK = 7.0
OPENING, OPENING_RADIUS = (0.0, 3.3), 2.95  # centre (x, z)
WHEELS_Y = -0.15  # the middle of the wheels' thickness, just before the wall

LAMP = (0.0, 5.0, 3.3)
PENDANT = (-4.4, -5.6, 4.0)

MODULE = 0.084  # a wheel's pitch diameter over its number of teeth, the same in all that mesh
LOOP = 24.0     # seconds after which every wheel is at its start angle

# Each wheel is driven by an earlier one, at this angle from it: (teeth, spokes, driver, degrees).
TRAIN = ((36, 6, None, None), (24, 5, 0, 22.0), (18, 4, 1, -89.0), (12, 3, 0, 85.0))
FIRST = (-0.72, 3.15)


def pitch_radius(teeth):
    return MODULE * teeth / 2


def wheels():
    """(teeth, spokes, x, z, start angle, turns a loop) of each wheel; angles from +x towards +z.

    Where two wheels touch, a tooth of one is in a gap of the other. If the driver, seen from its centre, is p teeth
    past a tooth's middle there, the driven wheel, which turns the other way, is half a tooth minus p past one.
    """
    passes = math.lcm(*(teeth for teeth, *_ in TRAIN))  # teeth that pass each contact in a loop: whole turns for all
    made = []
    for teeth, spokes, driver, degrees in TRAIN:
        if driver is None:
            made.append((teeth, spokes, *FIRST, 0.0, passes // teeth))
            continue
        other, _, x, z, start, turns = made[driver]
        towards = math.radians(degrees)
        distance = pitch_radius(other) + pitch_radius(teeth)
        past = other * (towards - start) / (2 * math.pi)
        angle = towards + math.pi - (0.5 - past) * 2 * math.pi / teeth
        made.append((teeth, spokes, x + distance * math.cos(towards), z + distance * math.sin(towards), angle,
                     -math.copysign(passes // teeth, turns)))
    return made
