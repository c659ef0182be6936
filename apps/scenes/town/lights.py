"""Two hundred lamps, cones and pyramids that shine down and away from their posts and walls, and the moon."""

import math

from mathutils import Vector

from kit import sample
from kit.geometry import place
from town.houses import kind_of
from town.plan import (BACK_LAMP, BACKS, CROSSING, DOOR_LAMP, END, FRONTS, HOUSES, KERB, LANE_INNER, POST_HEIGHT,
                       POST_ARM, SIGN, SQUARE, START)

SODIUM, WHITE, WARM = (1.0, 0.60, 0.22), (0.80, 0.90, 1.0), (1.0, 0.74, 0.42)
NEON = {"red": (1.0, 0.08, 0.10), "green": (0.15, 1.0, 0.35), "blue": (0.20, 0.35, 1.0), "pink": (1.0, 0.15, 0.70)}

DENSITY = 0.035
BEYOND = 0.15  # metres that a far plane lies below the ground

# Full angle, and tilt from straight down, in degrees. Half the angle is small enough for the tilt and the post's
# distance that neither post nor wall is in the cone.
POST_CONE, POST_TILT = 56.0, 24.0
WALL_CONE, WALL_TILT = 60.0, 31.0


def far_plane(height, half, tilt):
    """Distance along the axis at which the flattest ray of the cone's pyramid meets the ground."""
    return round(height * math.cos(half) / math.cos(tilt + half) + BEYOND, 2)


def lamp(name, position, outwards, colour, candela, degrees, tilt, window=None):
    """`outwards`: unit vector (x, y) to which the lamp is tilted; `window`: a pyramid's angles instead of a cone."""
    tilt = math.radians(tilt)
    direction = Vector((outwards[0] * math.sin(tilt), outwards[1] * math.sin(tilt), -math.cos(tilt)))
    half = math.radians((window[1] if window else degrees) / 2)
    settings = {"near": 0.1, "far": far_plane(position[2], half, tilt), "density": DENSITY}
    if window:
        settings.update({"shape": "frustum", "fov": list(window)})
    sample.spot(name, position, direction, colour, candela, degrees, 0.35, settings)


def build_moon():
    """The moon has density 0: it lights only walls and roofs."""
    direction = Vector((0.55, 0.35, -0.76)).normalized()
    town = Vector((0.0, (START + END) / 2, 0.0))
    sample.spot("Moon", town - 400.0 * direction, direction, (0.62, 0.74, 1.0), 0.7 * 400.0 ** 2, 50, 0.2, {
        "near": 100.0, "far": 700.0, "shadow": "none", "density": 0.0})


class Posts:
    def __init__(self, mesh):
        self.mesh = mesh

    def stand(self, name, foot, outwards, colour, candela):
        head = (foot[0] + POST_ARM * outwards[0], foot[1] + POST_ARM * outwards[1], POST_HEIGHT)
        lamp(name, head, outwards, colour, candela, POST_CONE, POST_TILT)
        place(name + ", post", self.mesh, head, (0, 0, math.atan2(outwards[1], outwards[0])))


def build_posts(mesh):
    posts = Posts(mesh)
    for i in range(28):  # alternately left and right
        side = -1 if i % 2 else 1
        posts.stand(f"Street {i + 1}", (side * (KERB + 0.5), START + 8.0 * (i + 1)), (-side, 0), SODIUM, 220)
    for side, name in ((-1, "left"), (1, "right")):
        for i in range(20):
            posts.stand(f"Lane {name} {i + 1}", (side * LANE_INNER, START + 6.0 + 12.1 * i), (side, 0), SODIUM, 160)
        for i in range(8):
            north = i % 2
            y = CROSSING[1] - 0.6 if north else CROSSING[0] + 0.6
            posts.stand(f"Cross street {name} {i + 1}", (side * (14.0 + 6.0 * i), y), (0, -1 if north else 1), SODIUM,
                        160)
        for i in range(6):
            posts.stand(f"Square {name} {i + 1}", (side * (5.0 + 9.5 * (i % 3)), SQUARE[0] + 10.0 + 22.0 * (i // 3)),
                        (side, 0), WHITE, 260)
    for i in range(20):
        posts.stand(f"Yard {i + 1}", (34.0 + 9.5 * (i % 4), -34.0 + 12.0 * (i // 4)), (1, 0), WHITE, 160)


def build_wall_lamps(signs):
    """Every house has a lamp over the door or shop window, and one at the back; some have a sign."""
    signs_left = 20
    for side, name in ((-1, "left"), (1, "right")):
        for i, y in enumerate(HOUSES):
            def out(lamp_place, front=True, side=side, y=y):
                distance, along, up = lamp_place
                x = FRONTS - distance if front else BACKS + distance
                return side * x, y - side * along, up

            shop = kind_of(i, side) in (1, 2)
            if shop:
                lamp(f"Window {name} {i + 1}", out((0.1, 3.0, 2.4)), (-side, 0), WARM, 40, 70, 32, (70.0, 50.0))
            else:
                lamp(f"Door {name} {i + 1}", out(DOOR_LAMP), (-side, 0), WARM, 32, WALL_CONE, WALL_TILT)
            lamp(f"Back {name} {i + 1}", out(BACK_LAMP, front=False), (side, 0), WARM, 28, WALL_CONE, WALL_TILT)
            if i % 8 < 5:
                colour = list(NEON)[(i + 2 * (side > 0)) % len(NEON)]
                lamp(f"Sign {name} {i + 1}", out(SIGN), (-side, 0), NEON[colour], 60, WALL_CONE, WALL_TILT)
                place(f"Sign {name} {i + 1}, blade", signs[colour], out(SIGN), (0, 0, math.pi if side > 0 else 0.0))
                signs_left -= 1
    assert signs_left == 0
