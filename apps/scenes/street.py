"""A street at night, under 200 lamps.

    blender --background --python-exit-code 1 --python apps/scenes/street.py -- OUTPUT.glb

README.md describes it. Lengths in metres; Blender's axes here (Z up), glTF's in the file.
"""

import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

from kit import sample, textures  # noqa: E402
from kit.materials import material, packed_image  # noqa: E402
from town import furniture, houses, lights  # noqa: E402


def build_cameras():
    level = sample.camera("Street", (2.6, -8.2, 1.7), (-1.2, 30.0, 3.4), 25, far=400.0)
    sample.camera("Roof", (-6.2, -24.0, 14.5), (5.0, 40.0, 0.0), 24, far=400.0)
    sample.camera("Across", (-6.4, 26.0, 4.6), (7.0, 44.0, 1.6), 22, far=400.0)
    bpy.context.scene.camera = level


def build():
    sample.begin()
    grain = packed_image("Grain", textures.stone_grain())
    asphalt = material("Asphalt", (0.05, 0.05, 0.052), grain=grain)
    paving = material("Paving", (0.13, 0.125, 0.12), grain=grain)
    grass = material("Grass", (0.03, 0.045, 0.02), grain=grain)
    walls = [material(name, colour) for name, colour in (
        ("Brick", (0.16, 0.07, 0.05)), ("Ochre plaster", (0.24, 0.17, 0.09)), ("Grey plaster", (0.17, 0.17, 0.17)),
        ("White plaster", (0.30, 0.28, 0.25)))]
    roof = material("Slate", (0.035, 0.035, 0.04))
    dark = material("Dark glass", (0.02, 0.022, 0.026))
    lit = material("Lit window", (0.0, 0.0, 0.0), (0.34, 0.22, 0.10))
    iron = material("Iron", (0.03, 0.035, 0.035))
    glow = material("Lamp glow", (0.0, 0.0, 0.0), (4.0, 2.8, 1.4))
    rubber = material("Rubber", (0.012, 0.012, 0.012))
    bark = material("Bark", (0.06, 0.045, 0.035))
    foliage = material("Foliage", (0.05, 0.09, 0.03))
    paints = [material(f"Paint, {name}", colour) for name, colour in (
        ("red", (0.22, 0.02, 0.02)), ("blue", (0.03, 0.07, 0.20)), ("silver", (0.30, 0.30, 0.31)))]

    furniture.build_ground(asphalt, paving, grass)
    houses.build_houses(walls, roof, dark, lit)
    houses.build_town_hall(walls[3], roof, dark, lit)
    furniture.build_cars(paints, dark, rubber)
    furniture.build_trees(bark, foliage)
    build_cameras()
    lights.build_posts(furniture.lamp_post(iron, glow))
    lights.build_wall_lamps({name: furniture.sign(name, material(f"Neon, {name}", (0, 0, 0), [1.2 * c for c in colour]),
                                                  iron) for name, colour in lights.NEON.items()})
    lamps = sum(item.type == "LIGHT" for item in bpy.data.objects)
    assert lamps == 200, lamps
    lights.build_moon()
    return {}


if __name__ == "__main__":
    sample.run(build)
