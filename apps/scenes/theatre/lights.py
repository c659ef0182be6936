"""The rig: 32 spots in seven groups, some of them off in this cue, some out of the picture."""

import math

from mathutils import Vector

from kit import sample
from kit.geometry import place
from theatre.plan import BACKDROP, CEILING, LAMP_HEIGHT, STAGE_HALF, STALLS_BACK, STALLS_FLOOR, TRUSSES

MAGENTA, CYAN, AMBER, BLUE = (1.0, 0.10, 0.55), (0.10, 0.85, 1.0), (1.0, 0.55, 0.10), (0.12, 0.22, 1.0)
RED, GREEN, LAVENDER, STRAW = (1.0, 0.08, 0.05), (0.15, 1.0, 0.30), (0.62, 0.42, 1.0), (1.0, 0.82, 0.52)

DENSITY = 0.075
NEAR = 0.3
BEYOND = 0.15  # metres that a far plane lies behind the lit surface
HAZE = {"scale": [2.5, 2.5], "scroll1": [0.02, 0.01], "scroll2": [-0.015, 0.02], "gain": 1 / 0.3, "texture": "Haze"}


def far_plane(position, direction, half_angle, floor):
    """Distance along the axis at which the last corner ray of the lamp's pyramid meets floor, wall, ceiling or
    backdrop."""
    turned = sample.looking(direction)
    tan_half_angle = math.tan(half_angle)
    low, high = (-STAGE_HALF, STALLS_BACK, floor), (STAGE_HALF, BACKDROP, CEILING)
    farthest = 0.0
    for x in (-tan_half_angle, tan_half_angle):
        for y in (-tan_half_angle, tan_half_angle):
            ray = turned @ Vector((x, y, -1.0))  # one metre along the axis
            hits = [((high if ray[i] > 0 else low)[i] - position[i]) / ray[i] for i in range(3) if abs(ray[i]) > 1e-9]
            farthest = max(farthest, min(hits))
    return round(farthest + BEYOND, 2)


class Rig:
    def __init__(self, housing):
        self.housing = housing

    def lamp(self, name, position, target, colour, candela, degrees, gobo, haze=False, cone=False, floor=0.0):
        position = Vector(position)
        direction = Vector(target) - position
        settings = {"near": NEAR, "far": far_plane(position, direction, math.radians(degrees / 2), floor),
                "density": DENSITY, "cookie": gobo}
        if not cone:
            settings.update({"shape": "frustum", "fov": [degrees, degrees]})
        if haze:
            settings["noise"] = dict(HAZE)
        sample.spot(name, position, direction, colour, candela, degrees, 0.2, settings)
        place(name + ", housing", self.housing, position, sample.looking(direction).to_euler())


def build_lights(housing):
    rig = Rig(housing)
    front, middle, back = TRUSSES

    # Front truss: washes on the backdrop and the set, two of them off in this cue.
    washes = ((-6.0, (-6.4, BACKDROP, 3.4), BLUE, 0, "Stars"), (-4.4, (-4.6, 7.2, 1.0), AMBER, 1500, "Leaves"),
              (-2.8, (-2.7, 4.7, 0.8), STRAW, 1500, "Breakup"), (-1.2, (-1.6, BACKDROP, 4.2), BLUE, 2300, "Stars"),
              (1.2, (1.6, BACKDROP, 4.2), BLUE, 2300, "Stars"), (2.8, (3.1, 4.3, 0.8), STRAW, 1500, "Breakup"),
              (4.4, (5.0, 7.0, 1.4), GREEN, 1500, "Leaves"), (6.0, (6.4, BACKDROP, 3.4), BLUE, 0, "Stars"))
    for i, (x, target, colour, candela, gobo) in enumerate(washes):
        rig.lamp(f"Front {i + 1}", (x, front, LAMP_HEIGHT), target, colour, candela, 15, gobo)

    # Middle truss: a fan of narrow beams; its outer pair is cone lights.
    for i, (colour, candela) in enumerate(((MAGENTA, 1500), (CYAN, 1500), (MAGENTA, 0), (LAVENDER, 1500),
                                           (LAVENDER, 1500), (CYAN, 0), (MAGENTA, 1500), (CYAN, 1500))):
        x = -6.3 + 1.8 * i
        rig.lamp(f"Middle {i + 1}", (x, middle, LAMP_HEIGHT), (1.25 * x, middle - 0.3, 0.0), colour, candela, 11,
                 "Bars" if i % 2 else "Rings", cone=i in (0, 7))

    # Back truss: towards the stalls, over the heads; the two in the middle have haze.
    for i, (colour, candela) in enumerate(((RED, 2000), (AMBER, 2000), (STRAW, 2650), (STRAW, 2650),
                                           (AMBER, 0), (RED, 2000))):
        x = -5.0 + 2.0 * i
        rig.lamp(f"Back {i + 1}", (x, back, LAMP_HEIGHT), (1.3 * x, 3.6, 0.0), colour, candela, 13,
                 "Shards" if i in (2, 3) else "Breakup", haze=i in (2, 3))

    # On the floor before the backdrop, upwards.
    for i, candela in enumerate((1500, 1500, 0, 1500)):
        x = (-6.4, -2.6, 2.6, 6.4)[i]
        rig.lamp(f"Floor {i + 1}", (x, 10.1, 0.35), (1.3 * x, 10.2, 9.0), CYAN, candela, 9, "Bars")

    # From the wings, low across the stage.
    rig.lamp("Wing left", (-9.2, 5.2, 2.7), (8.0, 5.8, 0.4), GREEN, 1500, 10, "Leaves", haze=True)
    rig.lamp("Wing right", (9.2, 5.2, 2.7), (-8.0, 5.8, 0.4), AMBER, 0, 10, "Leaves")

    # House lights over the stalls' back rows: behind every camera.
    for i, x in enumerate((-6.0, -2.0, 2.0, 6.0)):
        rig.lamp(f"House {i + 1}", (x, -20.5, CEILING - 0.8), (x, -19.5, STALLS_FLOOR), STRAW, 500, 24, "Breakup",
                 cone=True, floor=STALLS_FLOOR)
