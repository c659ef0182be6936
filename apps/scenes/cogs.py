"""Cog wheels turning before a lamp, in dusty air.

    blender --background --python-exit-code 1 --python apps/scenes/cogs.py -- OUTPUT.glb

README.md describes it. Lengths in metres; Blender's axes here (Z up), glTF's in the file.
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

from clockwork import lights, room, wheels  # noqa: E402
from kit import sample, textures  # noqa: E402
from kit.materials import material, packed_image  # noqa: E402


def build_cameras():
    before = sample.camera("Before the wheels", (4.4, -7.4, 1.3), (-0.4, -0.8, 3.0), 23)
    sample.camera("Beside the shafts", (6.4, -8.6, 2.3), (-2.6, -2.8, 2.3), 20)
    sample.camera("At the teeth", (2.4, -2.6, 2.2), (0.1, 0.6, 3.6), 18)
    bpy.context.scene.camera = before


def build():
    sample.begin(wheels.FRAMES_PER_SECOND)
    grain = packed_image("Stone grain", textures.stone_grain())
    stone = material("Stone", (0.16, 0.14, 0.12), grain=grain)
    trim = material("Cut stone", (0.24, 0.21, 0.18), grain=grain)
    floor = material("Flagstone", (0.14, 0.12, 0.10), grain=grain)
    soot = material("Soot", (0.02, 0.02, 0.02), grain=grain)
    brass = material("Brass", (0.30, 0.19, 0.06))
    iron = material("Iron", (0.04, 0.04, 0.045))
    wood = material("Oak", (0.13, 0.075, 0.04))
    glow = material("Pendant glow", (0.0, 0.0, 0.0), (2.2, 3.1, 4.0))
    room.build_shell(floor, stone, soot)
    room.build_pierced_wall(stone, trim)
    room.build_furniture(wood, iron, glow)
    wheels.build_wheels(brass, iron)
    wheels.build_bearings(iron)
    build_cameras()
    lights.build_lights()
    return {"Dust": textures.dust()}


if __name__ == "__main__":
    sample.run(build)
