"""Cog wheels: teeth, rim, spokes and hub, and their turning."""

import math

import bpy

from clockwork.plan import LOOP, MODULE, OPENING, OPENING_RADIUS, WHEELS_Y, pitch_radius, wheels
from kit.geometry import Part, box, place, rod

FRAMES_PER_SECOND = 5  # wheels turn evenly, and quaternions between keys too, so few keys are enough
THICKNESS = 0.16


def tooth_outline(teeth):
    """Radius and angle of the points round a wheel. Flanks lean so that the teeth of two wheels pass each other."""
    radius, pitch = pitch_radius(teeth), 2 * math.pi / teeth
    root, tip = radius - 1.2 * MODULE, radius + 0.95 * MODULE
    profile = ((root, -0.33), (radius, -0.235), (tip, -0.12), (tip, 0.12), (radius, 0.235), (root, 0.33))
    return [(r, (i + share) * pitch) for i in range(teeth) for r, share in profile]


def ring(part, outer, inner, half, slot=0):
    """A flat ring between two closed outlines of equally many points, in the plane of x and z, with all four sides."""
    def points(outline, y):
        return [(r * math.cos(a), y, r * math.sin(a)) for r, a in outline]

    for rows in ((points(outer, -half), points(inner, -half)), (points(inner, half), points(outer, half)),
                 (points(outer, half), points(outer, -half)), (points(inner, -half), points(inner, half))):
        part.grid(rows, slot, closed=True)


def wheel(teeth, spokes, brass, iron):
    part = Part(brass, iron)
    outer = tooth_outline(teeth)
    rim, hub, bore, half = pitch_radius(teeth) - 2.9 * MODULE, 0.16 + 0.004 * teeth, 0.06, THICKNESS / 2
    ring(part, outer, [(rim, a) for _, a in outer], half)
    around = [2 * math.pi * i / 24 for i in range(24)]
    ring(part, [(hub, a) for a in around], [(bore, a) for a in around], 1.3 * half)
    for i in range(spokes):
        a = 2 * math.pi * (i + 0.5) / spokes
        out, side = (math.cos(a), math.sin(a)), (-math.sin(a), math.cos(a))
        section = ((-1, -1), (1, -1), (1, 1), (-1, 1))
        rows = []
        for radius, wide in ((0.9 * hub, 0.085), (rim + 0.02, 0.055)):
            rows.append([(out[0] * radius + side[0] * wide * s, 0.7 * half * y, out[1] * radius + side[1] * wide * s)
                         for s, y in section])
        part.grid(rows, closed=True)
    rod(part, (0, -2.2 * half, 0), (0, 0.5, 0), bore, bore, 12, slot=1)
    part.face([(bore * math.cos(a), -2.2 * half, bore * math.sin(a)) for a in around[::2]], 1)
    return part.mesh(f"Wheel of {teeth}", smooth_below=30)


def build_wheels(brass, iron):
    frames = round(LOOP * FRAMES_PER_SECOND)
    for teeth, spokes, x, z, start, turns in wheels():
        item = place(f"Wheel of {teeth}", wheel(teeth, spokes, brass, iron), (x, WHEELS_Y, z))
        # About +y from x to z is Blender's negative sense.
        for frame, angle in ((0, start), (frames, start + 2 * math.pi * turns)):
            item.rotation_euler = (0, -angle, 0)
            item.keyframe_insert("rotation_euler", frame=frame)
        for curve in item.animation_data.action.fcurves:
            for key in curve.keyframe_points:
                key.interpolation = "LINEAR"
        item.animation_data.action.name = f"Wheel of {teeth} turns"
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 0, frames


def build_bearings(iron):
    """A bar across the opening behind each axle."""
    for teeth, _, x, z, _, _ in wheels():
        part = Part(iron)
        half_length = math.sqrt(OPENING_RADIUS ** 2 - (z - OPENING[1]) ** 2) + 0.1
        box(part, (OPENING[0] - half_length, 0.24, z - 0.05), (OPENING[0] + half_length, 0.34, z + 0.05))
        part.place(f"Bearing of {teeth}")
