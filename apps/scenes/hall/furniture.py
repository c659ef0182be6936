"""Furniture of the hall: portal, pews, lantern, and the censer that swings in the light."""

import math

import bpy
from mathutils import Vector

from hall.plan import BACK, CENSER, CENSER_HOOK, HEIGHT, LANTERN, PORTAL
from kit.geometry import Part, arch, bar, box, lathe, place

FRAMES_PER_SECOND = 24
SWING = math.radians(5)


def build_portal(pale, oak):
    half, spring, points = 1.15, 2.3, arch(1.15, 0.7, 8)
    part = Part(pale, oak)

    def outline(grow):
        return [(-half - grow, 0)] + [(u * (1 + grow / half), spring + r * (1 + grow / half)) for u, r in points] + \
               [(half + grow, 0)]

    bar(part, outline(0.1), 0.24, 0.24, 0.1, 0.07)
    bar(part, outline(0.34), 0.26, 0.44, 0.1, 0.10)
    planks = 8
    for k in range(planks):
        a, b = -half + 2 * half * k / planks + 0.008, -half + 2 * half * (k + 1) / planks - 0.008
        top = [(u, spring + r) for u, r in points if a < u < b]
        rise = [spring + math.sqrt((half + 0.7) ** 2 - (abs(u) + 0.7) ** 2) for u in (a, b)]
        part.face([(0.04, a, 0), (0.04, b, 0), (0.04, b, rise[1])] + [(0.04, *p) for p in reversed(top)]
                  + [(0.04, a, rise[0])], 1)
    place("Portal", part.mesh("Portal", grain=1.3), (PORTAL, BACK, 0), (0, 0, -math.pi / 2))


def build_pews(oak):
    part = Part(oak)
    length = 2.4
    box(part, (0, -0.22, 0.42), (length, 0.2, 0.47))
    for low, high in ((0.47, 0.56), (0.60, 0.72), (0.76, 0.90)):
        box(part, (0, -0.29, low), (length, -0.25, high))
    for x in (0, length / 2, length):
        box(part, (x - 0.04, -0.32, 0), (x + 0.04, -0.22, 0.98))
        box(part, (x - 0.035, -0.24, 0), (x + 0.035, 0.22, 0.42))
    box(part, (-0.04, -0.34, 0.90), (length + 0.04, -0.21, 0.95))
    mesh = part.mesh("Pew")
    for i, y in enumerate((7.6, 9.2, 10.8)):
        place(f"Pew {i + 1}", mesh, (2.75, y, 0))


def build_lantern(iron, glow):
    x, y, z = LANTERN
    part = Part(iron, glow)
    lathe(part, [(0.30, -0.02), (0.28, 0.0), (0.16, 0.14), (0.05, 0.2), (0.02, 0.3), (0.012, 0.32)], 16)
    lathe(part, [(0.012, 0.3), (0.012, HEIGHT - z)], 6)
    lathe(part, [(0.0, 0.0), (0.07, 0.01), (0.10, 0.05), (0.07, 0.11), (0.0, 0.12)], 12, slot=1)
    place("Lantern", part.mesh("Lantern", smooth_below=40), LANTERN)


def build_censer(brass, iron):
    """Hangs in the beam of the nearest window and swings as a pendulum of its length does."""
    length = CENSER_HOOK - CENSER[2]
    part = Part(brass, iron)
    bowl = [(0.02, -0.30), (0.10, -0.29), (0.05, -0.25), (0.05, -0.22), (0.15, -0.16), (0.19, -0.07), (0.20, 0.0),
            (0.21, 0.015), (0.19, 0.03), (0.17, 0.10), (0.11, 0.18), (0.06, 0.22), (0.05, 0.27), (0.03, 0.33),
            (0.01, 0.36)]
    lathe(part, [(r, z - length) for r, z in bowl], 20)
    lathe(part, [(0.012, 0.3 - length), (0.012, 0.0)], 6, slot=1)
    for k in range(3):
        a = 2 * math.pi * k / 3
        foot, top = Vector((0.2 * math.cos(a), 0.2 * math.sin(a), 0.01 - length)), Vector((0, 0, 1.1 - length))
        side = Vector((-math.sin(a), math.cos(a), 0)) * 0.008
        part.face((foot - side, foot + side, top + side, top - side), 1)
        part.face((foot + side, foot - side, top - side, top + side), 1)
    item = place("Censer", part.mesh("Censer", smooth_below=40), (CENSER[0], CENSER[1], CENSER_HOOK))
    period = 2 * math.pi * math.sqrt(length / 9.81)
    frames = round(period * FRAMES_PER_SECOND)
    for frame in range(frames + 1):
        swing = SWING * math.sin(2 * math.pi * frame / frames)
        item.rotation_euler = (0.35 * swing, swing, 0)
        item.keyframe_insert("rotation_euler", frame=frame)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 0, frames
    item.animation_data.action.name = "Censer swings"
