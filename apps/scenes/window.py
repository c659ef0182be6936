"""The sample scene: a hall with tall windows and columns, dusty air, low sun.

    blender --background --python apps/scenes/window.py -- OUTPUT.glb

README.md beside this file says what is in it. Lengths in metres; Blender's axes here (Z up), glTF's in the file.
"""

import math
import os
import sys

import bpy
import numpy
from mathutils import Matrix, Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.dont_write_bytecode = True

import glb  # noqa: E402
import textures  # noqa: E402
from geometry import Part, arch, bar, box, lathe, pierced_wall, place, tile  # noqa: E402

# The hall: windows pierce the wall at WINDOW_WALL; the arcade divides the aisle behind it from the nave.
WINDOW_WALL = -5.0
WALL_THICKNESS = 0.7
ARCADE = -1.7
NAVE_WALL = 5.5
FRONT, BACK = -5.0, 17.0
HEIGHT = 9.0

WINDOWS = (3.0, 6.5, 10.0)  # centres along y
WINDOW_HALF, SILL, WINDOW_SPRING = 1.0, 1.9, 5.3
WINDOW_ARCH = arch(WINDOW_HALF, 0.6, 10)
TRACERY = WINDOW_WALL - 0.4
PANE_HEIGHT = 0.85

COLUMNS = (-2.25, 1.25, 4.75, 8.25, 11.75, 15.25)
COLUMN_TOP = 4.4
BAY_HALF = 1.4

# Low sun through the windows: a lamp far enough away for its rays to be near parallel.
AIM = Vector((TRACERY, 6.5, 4.3))
SUN_DISTANCE = 16.0
ELEVATION, AZIMUTH = math.radians(33), math.radians(10)
SUN = Vector((math.cos(ELEVATION) * math.cos(AZIMUTH), math.cos(ELEVATION) * math.sin(AZIMUTH), -math.sin(ELEVATION)))

LUMEN_PER_WATT = 683  # the exporter turns Blender's watts into candela with it, spread over the whole sphere

FRAMES_PER_SECOND = 24
SWING_SECONDS = 5.0


def material(name, colour, emission=None):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = 0.8
    if emission:
        shader.inputs["Emission"].default_value = (*emission, 1)
        shader.inputs["Emission Strength"].default_value = 1.0
    made.use_backface_culling = True
    return made


def courses(part, y_range, z_range, size, openings, to_world, across, up, slots):
    """Ashlar in running bond, left out where `openings` (low y, high y, low z, high z) are."""
    (y0, y1), (z0, z1) = y_range, z_range
    length, height = size
    for row in range(round((z1 - z0) / height)):
        z = z0 + row * height
        taken = sorted((a, b) for a, b, low, high in openings if low < z + height - 0.01 and high > z + 0.01)
        free, at = [], y0
        for a, b in taken:
            free.append((at, a))
            at = b
        free.append((at, y1))
        for a, b in free:
            edge = y0 - (row % 2) * length / 2
            count = 0
            while edge < b:
                low, high = max(a, edge), min(b, edge + length)
                if high - low > 0.08:
                    slot = slots[(row * 7 + count * 5 + (row * count) % 3) % len(slots)]
                    tile(part, to_world(low, z), across, up, (high - low, height), 0.025, slot)
                edge += length
                count += 1


def build_floor(pale, dark):
    part = Part(pale, dark)
    side = 1.05
    for i in range(math.ceil((NAVE_WALL - WINDOW_WALL) / side)):
        for j in range(math.ceil((BACK - FRONT) / side)):
            tile(part, (WINDOW_WALL + i * side, FRONT + j * side, -0.012), (1, 0, 0), (0, 1, 0), (side, side), 0.012,
                 (i + j) % 2)
    part.place("Floor")


def build_walls(stone, pale, shade):
    openings = [(y, SILL, WINDOW_SPRING, WINDOW_ARCH) for y in WINDOWS]
    wall = Part(stone, pale, shade)
    pierced_wall(wall, (WINDOW_WALL - WALL_THICKNESS, WINDOW_WALL), (FRONT, BACK), (-0.2, HEIGHT), openings, 0, 1)
    margin = 0.28
    rise = max(r for _, r in WINDOW_ARCH)
    courses(wall, (FRONT, BACK), (0.0, HEIGHT), (1.2, 0.5),
            [(y - WINDOW_HALF - margin, y + WINDOW_HALF + margin, SILL - 0.35, WINDOW_SPRING + rise + margin)
             for y in WINDOWS],
            lambda y, z: (WINDOW_WALL, y, z), (0, 1, 0), (0, 0, 1), (0, 0, 2))
    wall.place("Window wall")

    frames = Part(pale)
    for y in WINDOWS:
        outline = [(y + u * 1.13, WINDOW_SPRING + r * 1.13) for u, r in WINDOW_ARCH]
        bar(frames, [(outline[0][0], SILL)] + outline + [(outline[-1][0], SILL)], 0.26, 0.16, WINDOW_WALL, 0.05)
        box(frames, (WINDOW_WALL - 0.3, y - WINDOW_HALF - 0.28, SILL - 0.25),
            (WINDOW_WALL + 0.16, y + WINDOW_HALF + 0.28, SILL))
    frames.place("Window surrounds")

    shell = Part(stone, shade)
    x0, x1 = WINDOW_WALL, NAVE_WALL
    courses(shell, (0, x1 - x0), (0.0, HEIGHT), (1.2, 0.5), [], lambda u, z: (x0 + u, BACK, z), (1, 0, 0), (0, 0, 1),
            (0, 0, 1))
    shell.face(((x0, BACK, 0), (x1, BACK, 0), (x1, BACK, HEIGHT), (x0, BACK, HEIGHT)))
    shell.face(((x1, FRONT, 0), (x0, FRONT, 0), (x0, FRONT, HEIGHT), (x1, FRONT, HEIGHT)))
    shell.face(((x1, BACK, 0), (x1, FRONT, 0), (x1, FRONT, HEIGHT), (x1, BACK, HEIGHT)))
    shell.place("Hall walls")


def build_ceiling(plaster, wood):
    part = Part(plaster, wood)
    thick = 0.3
    box(part, (WINDOW_WALL - WALL_THICKNESS, FRONT, HEIGHT), (NAVE_WALL, BACK, HEIGHT + thick), 0)
    for k in range(11):
        y = FRONT + 1 + k * 2.0
        box(part, (ARCADE, y - 0.16, HEIGHT - 0.42), (NAVE_WALL, y + 0.16, HEIGHT), 1)
        box(part, (WINDOW_WALL, y - 0.12, HEIGHT - 0.3), (ARCADE, y + 0.12, HEIGHT), 1)
    part.place("Ceiling")


def build_arcade(stone, pale):
    points = arch(BAY_HALF, 0.5, 10)
    bays = [((a + b) / 2, COLUMN_TOP, COLUMN_TOP, points) for a, b in zip(COLUMNS, COLUMNS[1:])]
    wall = Part(stone, pale)
    pierced_wall(wall, (ARCADE - 0.34, ARCADE + 0.34), (FRONT, BACK), (COLUMN_TOP, HEIGHT), bays, 0, 1)
    edges = [FRONT] + [c + s * BAY_HALF for c, _, _, _ in bays for s in (-1, 1)] + [BACK]
    for a, b in zip(edges[::2], edges[1::2]):
        wall.face([(ARCADE + sx * 0.34, y, COLUMN_TOP) for sx, y in ((-1, a), (-1, b), (1, b), (1, a))])
    wall.place("Arcade")
    mouldings = Part(pale)
    for centre, spring, _, _ in bays:
        for side in (-1, 1):
            bar(mouldings, [(centre + u * 1.06, spring + r * 1.06) for u, r in points], 0.16, 0.12, ARCADE + side * 0.34,
                0.04)
    mouldings.place("Arch mouldings")


def build_columns(pale):
    part = Part(pale)
    box(part, (-0.55, -0.55, 0.0), (0.55, 0.55, 0.22))
    attic_base = [(0.54, 0.22), (0.55, 0.27), (0.54, 0.32), (0.47, 0.345), (0.455, 0.39), (0.48, 0.42), (0.495, 0.45),
                  (0.48, 0.48), (0.42, 0.50)]
    shaft = []
    for drum in range(4):
        low, high = 0.52 + drum * 0.8, 0.52 + (drum + 1) * 0.8
        taper = 0.4 - 0.012 * drum
        shaft += [(taper - 0.012, low), (taper, low + 0.02), (taper - 0.01, high - 0.02), (taper - 0.022, high)]
    capital = [(0.37, 3.75), (0.42, 3.78), (0.43, 3.81), (0.40, 3.84), (0.375, 3.88), (0.39, 4.0), (0.43, 4.1),
               (0.5, 4.18), (0.52, 4.2)]
    lathe(part, attic_base + shaft + capital, 32)
    box(part, (-0.54, -0.54, 4.2), (0.54, 0.54, COLUMN_TOP))
    mesh = part.mesh("Column", smooth_below=40)
    for i, y in enumerate(COLUMNS):
        place(f"Column {i + 1}", mesh, (ARCADE, y, 0))


def build_tracery(iron):
    part = Part(iron)
    for y in WINDOWS:
        edge = [(y - WINDOW_HALF, SILL)] + [(y + u, WINDOW_SPRING + r) for u, r in WINDOW_ARCH] + \
               [(y + WINDOW_HALF, SILL)]
        bar(part, edge, 0.14, 0.16, TRACERY, 0.03)
        bar(part, [(y, SILL), (y, WINDOW_SPRING + 0.35)], 0.13, 0.16, TRACERY, 0.03)
        z = SILL + PANE_HEIGHT
        while z < WINDOW_SPRING - 0.1:
            bar(part, [(y - WINDOW_HALF, z), (y + WINDOW_HALF, z)], 0.1, 0.12, TRACERY, 0.025)
            z += PANE_HEIGHT
        half = WINDOW_HALF / 2
        for side in (-1, 1):
            bar(part, [(y + side * half + u, WINDOW_SPRING + r) for u, r in arch(half, 0.3, 6)], 0.1, 0.14, TRACERY, 0.025)
        circle = [(y + 0.3 * math.cos(a), WINDOW_SPRING + 0.86 + 0.3 * math.sin(a))
                  for a in (2 * math.pi * i / 20 for i in range(20))]
        bar(part, circle, 0.09, 0.14, TRACERY, 0.025, closed=True)
    part.place("Tracery", smooth_below=30)


def add_light(name, location, direction, colour, candela, cone_degrees, blend, tyndall):
    light = bpy.data.lights.new(name, "SPOT")
    light.color = colour
    light.energy = candela * 4 * math.pi / LUMEN_PER_WATT
    light.spot_size = math.radians(cone_degrees)
    light.spot_blend = blend
    light.shadow_soft_size = 0
    item = place(name, light, location, direction.to_track_quat("-Z", "Y").to_euler())
    item["tyndall"] = tyndall
    return item


def sun_frame():
    """Position and rotation of the sun's lamp, and how wide and deep its pyramid has to be."""
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
    """Returns the colour of the light that leaves the lamp at slope (x, y): what the pane there lets through."""
    clear = numpy.array((1.0, 0.93, 0.80))

    def colour_of(x, y):
        axes = numpy.array(rotation)
        rays = x[..., None] * axes[:, 0] + y[..., None] * axes[:, 1] - axes[:, 2]
        reach = (TRACERY - position.x) / rays[..., 0]
        wall_y = position.y + reach * rays[..., 1]
        wall_z = position.z + reach * rays[..., 2]
        colour = numpy.empty(x.shape + (3,))
        colour[:] = clear
        return colour

    return colour_of


def build_lights():
    position, rotation, fov, near, far = sun_frame()
    add_light("Sun through the windows", position, SUN, (1.0, 0.86, 0.68), 900, 60, 0.15, {
        "shape": "frustum", "fov": [round(math.degrees(a), 2) for a in fov],
        "near": round(near, 2), "far": round(far, 2), "shadow": "dynamic", "density": 0.08,
        "noise": {"scale": [3.0, 2.0], "scroll1": [0.011, 0.006], "scroll2": [-0.008, 0.009], "gain": 1 / 0.3}})
    return {"Sun through the windows": (textures.slide(512, fov, glass(position, rotation)), textures.dust())}


def build_cameras():
    def camera(name, eye, target, lens):
        data = bpy.data.cameras.new(name)
        data.lens = lens
        data.clip_start, data.clip_end = 0.1, 100.0
        item = place(name, data, eye, (Vector(target) - Vector(eye)).to_track_quat("-Z", "Y").to_euler())
        return item

    hall = camera("Hall", (4.3, -3.2, 1.6), (-2.2, 8.0, 3.0), 26)
    camera("Inside the beam", (2.2, 7.6, 1.3), (-5.0, 6.3, 4.2), 22)
    camera("Along the arcade", (-3.2, -3.5, 1.7), (-1.9, 8.0, 2.6), 26)
    bpy.context.scene.camera = hall


def build():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = FRAMES_PER_SECOND
    scene.render.resolution_x, scene.render.resolution_y = 1280, 720
    stone = material("Stone", (0.40, 0.36, 0.31))
    shade = material("Weathered stone", (0.31, 0.28, 0.25))
    pale = material("Pale stone", (0.55, 0.51, 0.45))
    slab = material("Pale slab", (0.50, 0.46, 0.40))
    dark = material("Dark slab", (0.14, 0.12, 0.11))
    wood = material("Oak", (0.09, 0.055, 0.03))
    iron = material("Lead", (0.05, 0.05, 0.055))
    sky = material("Sky", (0.0, 0.0, 0.0), (0.80, 0.90, 1.0))

    build_floor(slab, dark)
    build_walls(stone, pale, shade)
    build_ceiling(shade, wood)
    build_arcade(stone, pale)
    build_columns(pale)
    build_tracery(iron)
    backdrop = Part(sky)
    backdrop.face(((-40, -60, -20), (-40, 80, -20), (-40, 80, 60), (-40, -60, 60)))
    backdrop.place("Sky")
    build_cameras()
    return build_lights()


def export(path, slides):
    plain = path + ".plain.glb"
    bpy.ops.export_scene.gltf(filepath=plain, export_format="GLB", export_extras=True, export_cameras=True,
                              export_lights=True, export_texcoords=False, export_yup=True, export_apply=True,
                              export_animations=True)
    document, binary = glb.read(plain)
    os.remove(plain)
    for light, (cookie, noise) in slides.items():
        settings = glb.settings_of(document, light)
        settings["cookie"] = glb.add_texture(document, binary, "Stained glass", cookie)
        settings["noise"]["texture"] = glb.add_texture(document, binary, "Dust", noise)
    glb.write(path, document, binary)


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(arguments) != 1:
        sys.exit("usage: blender --background --python window.py -- OUTPUT.glb")
    slides = build()
    export(os.path.abspath(arguments[0]), slides)
