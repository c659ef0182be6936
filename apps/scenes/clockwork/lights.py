"""Two lamps: one behind the wheels, whose shadows turn in dusty air, and one with nothing in front of it."""

import math

from clockwork.plan import LAMP, OPENING, OPENING_RADIUS, PENDANT, ROOM_FRONT, WHEELS_Y
from kit.sample import spot

BEYOND = 0.1  # metres that a far plane lies behind the lit surface


def build_lights():
    x, y, z = LAMP
    half = math.atan((OPENING_RADIUS + 0.15) / (y - WHEELS_Y))
    assert (x, z) == OPENING, "the lamp's pyramid is as wide as the opening only on its axis"
    fov = round(math.degrees(2 * half), 2)
    spot("Behind the wheels", LAMP, (0, -1, 0), (1.0, 0.70, 0.36), 2600, fov, 0.1, {
        "shape": "frustum", "fov": [fov, fov], "near": 2.0, "far": round(y - ROOM_FRONT + BEYOND, 2),
        "shadow": "dynamic", "density": 0.06,
        "noise": {"scale": [2.6, 2.6], "scroll1": [0.012, 0.009], "scroll2": [-0.009, 0.013], "gain": 1 / 0.3,
                  "texture": "Dust"}})
    spot("Pendant", PENDANT, (0, 0, -1), (0.55, 0.78, 1.0), 60, 56, 0.5, {
        "near": 0.25, "far": round(PENDANT[2] + BEYOND, 2), "density": 0.1})
