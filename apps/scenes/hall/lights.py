"""The hall's three lamps, and the slides that the sun's lamp projects."""

import math

import numpy
from mathutils import Vector

from hall.plan import (BACK, FRONT, LANTERN, NAVE_WALL, PANE_HEIGHT, SILL, TRACERY, WALL_THICKNESS, WINDOW_ARCH,
                       WINDOW_HALF, WINDOW_SPRING, WINDOW_WALL, WINDOWS)
from kit import textures
from kit.sample import spot

# Low sun through the windows: a lamp so far away that its rays are nearly parallel.
AIM = Vector((TRACERY, 6.5, 4.3))
SUN_DISTANCE = 16.0
ELEVATION, AZIMUTH = math.radians(35), math.radians(-14)
SUN = Vector((math.cos(ELEVATION) * math.cos(AZIMUTH), math.cos(ELEVATION) * math.sin(AZIMUTH), -math.sin(ELEVATION)))

# Texels of the slide, 0.06 m at the windows: glass scatters, and detail finer than a slice's thickness only
# shows as a pattern of slices.
GLASS_BLUR = 1.6


def sun_frame():
    """Position and rotation of the sun's lamp, and the width and depth of its pyramid."""
    rotation = SUN.to_track_quat("-Z", "Y").to_matrix()
    position = AIM - SUN * SUN_DISTANCE
    top = WINDOW_SPRING + max(r for _, r in WINDOW_ARCH)
    rim = [Vector((x, y, z)) for x in (WINDOW_WALL, WINDOW_WALL - WALL_THICKNESS) for z in (SILL, top)
           for y in (WINDOWS[0] - WINDOW_HALF, WINDOWS[-1] + WINDOW_HALF)]
    seen = [rotation.transposed() @ (p - position) for p in rim]
    half_x = max(math.atan(abs(p.x) / -p.z) for p in seen)
    half_y = max(math.atan(abs(p.y) / -p.z) for p in seen)
    near = min(-p.z for p in seen) - 0.1
    room = [Vector((NAVE_WALL, y, 0)) for y in (FRONT, BACK)] + [Vector((NAVE_WALL, y, 3)) for y in (FRONT, BACK)]
    far = max(-(rotation.transposed() @ (p - position)).z for p in room) + 0.3
    return position, rotation, (2 * half_x * 1.02, 2 * half_y * 1.02), near, far


def glass(position, rotation):
    """Returns the colour of the light that leaves the lamp at slope (x, y), after the glass there.

    The glass is only in the slide: as geometry it would cast shadows.
    """
    straw, pale, rose, amber = (1.0, 0.92, 0.74), (0.94, 0.96, 0.92), (1.0, 0.76, 0.62), (1.0, 0.76, 0.40)
    ruby, blue = (1.0, 0.38, 0.24), (0.30, 0.52, 1.0)
    panes = numpy.array([straw, amber, straw, pale, rose, straw, pale])
    heads = numpy.array([ruby, blue])

    def colour_of(x, y):
        axes = numpy.array(rotation)
        rays = x[..., None] * axes[:, 0] + y[..., None] * axes[:, 1] - axes[:, 2]
        distance = (TRACERY - position.x) / rays[..., 0]
        across = position.y + distance * rays[..., 1]
        up = position.z + distance * rays[..., 2]
        window = numpy.abs(across[..., None] - numpy.array(WINDOWS)).argmin(axis=-1)
        right = across > numpy.array(WINDOWS)[window]

        # One colour per pane, in large pieces, so that beams are divided like the panes. Coloured heads.
        row = numpy.floor((up - SILL) / PANE_HEIGHT).astype(int)
        colour = panes[(row * 2 + right + window * 3) % len(panes)]
        return numpy.where((up > WINDOW_SPRING)[..., None], heads[(right + window) % len(heads)], colour)

    return colour_of


def build_lights():
    position, rotation, fov, near, far = sun_frame()
    spot("Sun through the windows", position, SUN, (1.0, 0.80, 0.56), 1500, 60, 0.15, {
        "shape": "frustum", "fov": [round(math.degrees(a), 2) for a in fov],
        "near": round(near, 2), "far": round(far, 2), "shadow": "dynamic", "density": 0.042,
        # World space, glTF's axes: nothing outside the windows, nothing under the floor.
        "clipPlanes": [[1.0, 0.0, 0.0, -TRACERY], [0.0, 1.0, 0.0, 0.0]],
        "noise": {"scale": [3.6, 2.0], "scroll1": [0.011, 0.006], "scroll2": [-0.008, 0.009], "gain": 1 / 0.3,
                  "texture": "Dust"},
        "cookie": "Stained glass"})
    spot("Lantern light", Vector(LANTERN), Vector((0, 0, -1)), (1.0, 0.62, 0.28), 14, 84, 0.6, {
        "shape": "cone", "near": 0.1, "far": round(LANTERN[2] + 0.1, 2), "shadow": "static", "density": 0.06})
    # Light reflected up by the pools of light on the floor. It lights only surfaces: with density 0 there are no
    # shafts.
    spot("Bounce from the floor", Vector((0.5, 6.0, -3.0)), Vector((0, 0, 1)), (1.0, 0.84, 0.66), 5, 140, 0.5, {
        "shape": "cone", "near": 0.5, "far": 25.0, "shadow": "none", "density": 0.0})
    slide = textures.slide(256, fov, glass(position, rotation), GLASS_BLUR)
    return {"Stained glass": slide, "Dust": textures.dust()}
