"""A theatre stage under 32 coloured gobo spots.

    blender --background --python-exit-code 1 --python apps/scenes/stage.py -- OUTPUT.glb

README.md describes it. Lengths in metres; Blender's axes here (Z up), glTF's in the file.
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

from kit import sample, textures  # noqa: E402
from kit.materials import material, packed_image  # noqa: E402
from theatre import gobos, house, lights, pieces  # noqa: E402


def build_cameras():
    stalls = sample.camera("Stalls", (0.8, -11.5, 1.1), (0.0, 5.0, 3.1), 31)
    sample.camera("Wings", (-8.3, 1.4, 1.7), (3.0, 6.4, 2.6), 20)
    sample.camera("Above", (7.2, 2.9, 6.6), (-1.6, 6.2, 0.6), 20)
    sample.camera("Among the dancers", (-1.2, 1.4, 1.5), (0.6, 9.0, 3.4), 18)
    bpy.context.scene.camera = stalls


def build():
    sample.begin()
    grain = packed_image("Boards", textures.boards())
    boards = material("Boards", (0.07, 0.055, 0.045), grain=grain)
    black = material("Black paint", (0.008, 0.008, 0.009))
    plaster = material("Plaster", (0.03, 0.018, 0.016))
    gold = material("Gilding", (0.20, 0.12, 0.035))
    velvet = material("Velvet", (0.10, 0.004, 0.006))
    wool = material("Black wool", (0.008, 0.008, 0.009))
    cloth = material("Sky cloth", (0.075, 0.08, 0.12))
    carpet = material("Carpet", (0.06, 0.02, 0.02))
    plush = material("Plush", (0.03, 0.004, 0.005))
    steel = material("Steel", (0.04, 0.04, 0.045))
    glow = material("Lens", (0.02, 0.02, 0.02), (4.0, 4.0, 4.0))
    paint = material("Pale paint", (0.22, 0.21, 0.19))
    bark = material("Bark", (0.16, 0.11, 0.08))
    silk = material("Silk", (0.26, 0.24, 0.23))
    skin = material("Skin", (0.24, 0.15, 0.11))

    house.build_shell(boards, black, plaster, cloth, carpet)
    house.build_proscenium(plaster, gold)
    house.build_curtains(velvet, wool)
    house.build_seats(plush)
    house.build_trusses(steel)
    pieces.build_stair(paint)
    pieces.build_gate(paint)
    pieces.build_tree(bark)
    pieces.build_figures(silk, skin)
    build_cameras()
    lights.build_lights(house.lamp_housing(steel, glow))
    return {**gobos.all_gobos(), "Haze": textures.dust()}


if __name__ == "__main__":
    sample.run(build)
