"""The sample scene: a hall with tall windows and columns, dusty air, low sun.

    blender --background --python-exit-code 1 --python apps/scenes/window.py -- OUTPUT.glb

README.md describes it. Lengths in metres; Blender's axes here (Z up), glTF's in the file.
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

from hall import furniture, lights, masonry  # noqa: E402
from kit import sample, textures  # noqa: E402
from kit.geometry import Part  # noqa: E402
from kit.materials import material, packed_image  # noqa: E402


def build_cameras():
    hall = sample.camera("Hall", (4.6, -3.6, 1.35), (-1.9, 8.0, 3.1), 25)
    sample.camera("Inside the beam", (1.5, 7.7, 1.2), (-5.0, 7.9, 3.8), 20)
    sample.camera("Along the arcade", (-3.5, -1.2, 1.6), (-2.3, 8.0, 2.6), 24)
    bpy.context.scene.camera = hall


def build():
    sample.begin(furniture.FRAMES_PER_SECOND)
    grain = packed_image("Stone grain", textures.stone_grain())
    stone = material("Stone", (0.44, 0.40, 0.34), grain=grain)
    shade = material("Weathered stone", (0.35, 0.31, 0.27), grain=grain)
    pale = material("Pale stone", (0.60, 0.56, 0.49), grain=grain)
    slab = material("Pale slab", (0.54, 0.49, 0.42), grain=grain)
    dark = material("Dark slab", (0.16, 0.14, 0.13), grain=grain)
    wood = material("Oak", (0.13, 0.075, 0.04))
    iron = material("Lead", (0.05, 0.05, 0.055))
    brass = material("Brass", (0.55, 0.36, 0.12))
    glow = material("Lantern glow", (0.0, 0.0, 0.0), (1.0, 0.62, 0.28))
    sky = material("Sky", (0.0, 0.0, 0.0), (0.36, 0.40, 0.44))

    masonry.build_floor(slab, dark)
    masonry.build_walls(stone, pale, shade)
    masonry.build_ceiling(shade, wood)
    masonry.build_arcade(stone, pale)
    masonry.build_columns(pale)
    masonry.build_tracery(iron)
    furniture.build_portal(pale, wood)
    furniture.build_pews(wood)
    furniture.build_censer(brass, iron)
    furniture.build_lantern(iron, glow)
    backdrop = Part(sky)
    backdrop.face(((-40, -60, -20), (-40, 80, -20), (-40, 80, 60), (-40, -60, 60)))
    backdrop.place("Sky")
    build_cameras()
    return lights.build_lights()


if __name__ == "__main__":
    sample.run(build)
