"""The sample scene: a hall with tall windows and columns, dusty air, low sun.

    blender --background --python apps/scenes/window.py -- OUTPUT.glb

README.md beside this file says what is in it. Lengths in metres; Blender's axes here (Z up), glTF's in the file.
"""

import math
import os
import sys
import tempfile

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
WINDOW_HALF, SILL, WINDOW_SPRING = 0.85, 1.9, 5.3
WINDOW_ARCH = arch(WINDOW_HALF, 0.5, 10)
TRACERY = WINDOW_WALL - 0.4
PANE_HEIGHT = 0.85

COLUMNS = tuple(-1.45 + 3.5 * i for i in range(-1, 5))
COLUMN_TOP = 4.4
BAY_HALF = 1.4

# Low sun through the windows: a lamp far enough away for its rays to be near parallel.
AIM = Vector((TRACERY, 6.5, 4.3))
SUN_DISTANCE = 16.0
ELEVATION, AZIMUTH = math.radians(35), math.radians(-14)
SUN = Vector((math.cos(ELEVATION) * math.cos(AZIMUTH), math.cos(ELEVATION) * math.sin(AZIMUTH), -math.sin(ELEVATION)))

LUMEN_PER_WATT = 683  # the exporter turns Blender's watts into candela with it, spread over the whole sphere

FRAMES_PER_SECOND = 24

PORTAL = 1.7
LANTERN = (PORTAL, 14.8, 4.3)
CENSER = Vector((0.5, 4.9, 1.8))
CENSER_HOOK = HEIGHT - 0.45
SWING = math.radians(5)


def packed_image(name, data):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, name + ".png")
        with open(path, "wb") as file:
            file.write(data)
        image = bpy.data.images.load(path)
        image.pack()
    image.name = name
    return image


def material(name, colour, emission=None, grain=None):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = 0.8
    if grain:
        picture = made.node_tree.nodes.new("ShaderNodeTexImage")
        picture.image = grain
        tint = made.node_tree.nodes.new("ShaderNodeMix")  # the one form that the exporter reads as a colour factor
        tint.data_type, tint.blend_type = "RGBA", "MULTIPLY"
        factor, a, b = (next(s for s in tint.inputs if s.identifier == i) for i in ("Factor_Float", "A_Color", "B_Color"))
        factor.default_value = 1.0
        b.default_value = (*colour, 1)
        made.node_tree.links.new(picture.outputs["Color"], a)
        result = next(s for s in tint.outputs if s.identifier == "Result_Color")
        made.node_tree.links.new(result, shader.inputs["Base Color"])
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
    part.place("Floor", grain=1.7)


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
    wall.place("Window wall", grain=2.3)

    surround = Part(pale)
    outline = [(u * 1.13, WINDOW_SPRING + r * 1.13) for u, r in WINDOW_ARCH]
    bar(surround, [(outline[0][0], SILL)] + outline + [(outline[-1][0], SILL)], 0.26, 0.16, 0, 0.05)
    box(surround, (-0.3, -WINDOW_HALF - 0.28, SILL - 0.25), (0.16, WINDOW_HALF + 0.28, SILL))
    mesh = surround.mesh("Window surround", grain=1.3)
    for i, y in enumerate(WINDOWS):
        place(f"Window surround {i + 1}", mesh, (WINDOW_WALL, y, 0))

    shell = Part(stone, shade)
    x0, x1 = WINDOW_WALL, NAVE_WALL
    courses(shell, (0, x1 - x0), (0.0, HEIGHT), (1.2, 0.5), [], lambda u, z: (x0 + u, BACK, z), (1, 0, 0), (0, 0, 1),
            (0, 0, 1))
    shell.face(((x0, BACK, 0), (x1, BACK, 0), (x1, BACK, HEIGHT), (x0, BACK, HEIGHT)))
    shell.face(((x1, FRONT, 0), (x0, FRONT, 0), (x0, FRONT, HEIGHT), (x1, FRONT, HEIGHT)))
    shell.face(((x1, BACK, 0), (x1, FRONT, 0), (x1, FRONT, HEIGHT), (x1, BACK, HEIGHT)))
    shell.place("Hall walls", grain=2.3)


def build_ceiling(plaster, wood):
    part = Part(plaster, wood)
    thick = 0.3
    box(part, (WINDOW_WALL - WALL_THICKNESS, FRONT, HEIGHT), (NAVE_WALL, BACK, HEIGHT + thick), 0)
    for k in range(11):
        y = FRONT + 1 + k * 2.0
        box(part, (ARCADE, y - 0.16, HEIGHT - 0.42), (NAVE_WALL, y + 0.16, HEIGHT), 1)
        box(part, (WINDOW_WALL, y - 0.12, HEIGHT - 0.3), (ARCADE, y + 0.12, HEIGHT), 1)
    part.place("Ceiling", grain=2.3)


def build_arcade(stone, pale):
    points = arch(BAY_HALF, 0.5, 10)
    bays = [((a + b) / 2, COLUMN_TOP, COLUMN_TOP, points) for a, b in zip(COLUMNS, COLUMNS[1:])]
    wall = Part(stone, pale)
    pierced_wall(wall, (ARCADE - 0.34, ARCADE + 0.34), (FRONT, BACK), (COLUMN_TOP, HEIGHT), bays, 0, 1)
    edges = [FRONT] + [c + s * BAY_HALF for c, _, _, _ in bays for s in (-1, 1)] + [BACK]
    for a, b in zip(edges[::2], edges[1::2]):
        wall.face([(ARCADE + sx * 0.34, y, COLUMN_TOP) for sx, y in ((-1, a), (-1, b), (1, b), (1, a))])
    wall.place("Arcade", grain=2.3)
    moulding = Part(pale)
    for side in (-1, 1):
        bar(moulding, [(u * 1.06, COLUMN_TOP + r * 1.06) for u, r in points], 0.16, 0.12, side * 0.34, 0.04)
    mesh = moulding.mesh("Arch moulding", grain=1.3)
    for i, (centre, _, _, _) in enumerate(bays):
        place(f"Arch moulding {i + 1}", mesh, (ARCADE, centre, 0))


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
    mesh = part.mesh("Column", smooth_below=40, grain=1.256, turned=True)
    for i, y in enumerate(COLUMNS):
        place(f"Column {i + 1}", mesh, (ARCADE, y, 0))


def build_tracery(lead):
    part = Part(lead)
    outline = [(u, WINDOW_SPRING + r) for u, r in WINDOW_ARCH]
    bar(part, [(-WINDOW_HALF, SILL)] + outline + [(WINDOW_HALF, SILL)], 0.14, 0.16, 0, 0.03)
    bar(part, [(0, SILL), (0, WINDOW_SPRING + 0.35)], 0.13, 0.16, 0, 0.03)
    for row in range(1, math.ceil((WINDOW_SPRING - SILL) / PANE_HEIGHT)):
        z = SILL + row * PANE_HEIGHT
        bar(part, [(-WINDOW_HALF, z), (WINDOW_HALF, z)], 0.1, 0.12, 0, 0.025)
    half = WINDOW_HALF / 2
    for side in (-1, 1):
        bar(part, [(side * half + u, WINDOW_SPRING + r) for u, r in arch(half, 0.3, 6)], 0.1, 0.14, 0, 0.025)
    oculus = [(0.28 * math.cos(a), WINDOW_SPRING + 0.72 + 0.28 * math.sin(a))
              for a in (2 * math.pi * i / 20 for i in range(20))]
    bar(part, oculus, 0.09, 0.14, 0, 0.025, closed=True)
    mesh = part.mesh("Tracery", smooth_below=30)
    for i, y in enumerate(WINDOWS):
        place(f"Tracery {i + 1}", mesh, (TRACERY, y, 0))


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
    """Returns the colour of the light that leaves the lamp at slope (x, y): what the glass there lets through.

    The glass is in the slide alone: as geometry it would throw shadows.
    """
    straw, ruby, blue, amber = (1.0, 0.94, 0.80), (1.0, 0.30, 0.20), (0.40, 0.62, 1.0), (1.0, 0.70, 0.28)
    quarries = numpy.array([straw, straw, straw, straw, (1.0, 0.97, 0.88), (1.0, 0.84, 0.55), (0.86, 0.95, 0.80)])
    borders = numpy.array([ruby, amber, blue, amber])

    def colour_of(x, y):
        axes = numpy.array(rotation)
        rays = x[..., None] * axes[:, 0] + y[..., None] * axes[:, 1] - axes[:, 2]
        reach = (TRACERY - position.x) / rays[..., 0]
        across = position.y + reach * rays[..., 1]
        up = position.z + reach * rays[..., 2]
        across -= numpy.array(WINDOWS)[numpy.abs(across[..., None] - numpy.array(WINDOWS)).argmin(axis=-1)]

        # Diamond quarries, each of its own glass.
        p, q = across / 0.21 + up / 0.30, across / 0.21 - up / 0.30
        kind = (numpy.floor(p) * 7 + numpy.floor(q) * 13 + numpy.floor(p) * numpy.floor(q)).astype(int)
        colour = quarries[kind % len(quarries)]
        lead = numpy.minimum(p % 1, q % 1) < 0.09

        # A coloured border along both lights of the window, and coloured heads.
        light = numpy.abs(numpy.abs(across) - WINDOW_HALF / 2)
        border = light > WINDOW_HALF / 2 - 0.17
        piece = numpy.floor(up / 0.34).astype(int)
        colour = numpy.where(border[..., None], borders[piece % len(borders)], colour)
        lead = numpy.where(border, (up / 0.34) % 1 < 0.06, lead)
        head = up > WINDOW_SPRING
        colour = numpy.where(head[..., None], numpy.where((kind % 3 == 0)[..., None], ruby, blue), colour)
        return colour * numpy.where(lead, 0.15, 1.0)[..., None]

    return colour_of


def build_censer(brass, iron):
    """Hangs in the beam of the nearest window and swings as a pendulum of its length does."""
    length = CENSER_HOOK - CENSER.z
    part = Part(brass, iron)
    bowl = [(0.02, -0.30), (0.10, -0.29), (0.05, -0.25), (0.05, -0.22), (0.15, -0.16), (0.19, -0.07), (0.20, 0.0),
            (0.21, 0.015), (0.19, 0.03), (0.17, 0.10), (0.11, 0.18), (0.06, 0.22), (0.05, 0.27), (0.03, 0.33), (0.01, 0.36)]
    lathe(part, [(r, z - length) for r, z in bowl], 20)
    lathe(part, [(0.012, 0.3 - length), (0.012, 0.0)], 6, slot=1)
    for k in range(3):
        a = 2 * math.pi * k / 3
        foot, top = Vector((0.2 * math.cos(a), 0.2 * math.sin(a), 0.01 - length)), Vector((0, 0, 1.1 - length))
        side = Vector((-math.sin(a), math.cos(a), 0)) * 0.008
        part.face((foot - side, foot + side, top + side, top - side), 1)
        part.face((foot + side, foot - side, top - side, top + side), 1)
    item = place("Censer", part.mesh("Censer", smooth_below=40), (CENSER.x, CENSER.y, CENSER_HOOK))
    period = 2 * math.pi * math.sqrt(length / 9.81)
    frames = round(period * FRAMES_PER_SECOND)
    for frame in range(0, frames + 1, 2):
        swing = SWING * math.sin(2 * math.pi * frame / frames)
        item.rotation_euler = (0.35 * swing, swing, 0)
        item.keyframe_insert("rotation_euler", frame=frame)
    bpy.context.scene.frame_start, bpy.context.scene.frame_end = 0, frames
    item.animation_data.action.name = "Censer swings"


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


def build_lights():
    position, rotation, fov, near, far = sun_frame()
    add_light("Sun through the windows", position, SUN, (1.0, 0.80, 0.56), 1700, 60, 0.15, {
        "shape": "frustum", "fov": [round(math.degrees(a), 2) for a in fov],
        "near": round(near, 2), "far": round(far, 2), "shadow": "dynamic", "density": 0.06,
        "noise": {"scale": [3.0, 2.0], "scroll1": [0.011, 0.006], "scroll2": [-0.008, 0.009], "gain": 1 / 0.3}})
    add_light("Lantern light", Vector(LANTERN), Vector((0, 0, -1)), (1.0, 0.62, 0.28), 26, 84, 0.6, {
        "shape": "cone", "near": 0.1, "far": round(LANTERN[2] + 0.1, 2), "shadow": "static", "density": 0.06})
    # What the pools of light on the floor send back up. It lights surfaces alone: in air of density 0 it throws
    # no shafts, and none are simulated.
    add_light("Bounce from the floor", Vector((0.5, 6.0, -3.0)), Vector((0, 0, 1)), (1.0, 0.84, 0.66), 5, 140, 0.5, {
        "shape": "cone", "near": 0.5, "far": 25.0, "shadow": "none", "density": 0.0})
    return {"Sun through the windows": (textures.slide(512, fov, glass(position, rotation)), textures.dust())}


def build_cameras():
    def camera(name, eye, target, lens):
        data = bpy.data.cameras.new(name)
        data.lens = lens
        data.clip_start, data.clip_end = 0.1, 100.0
        item = place(name, data, eye, (Vector(target) - Vector(eye)).to_track_quat("-Z", "Y").to_euler())
        return item

    hall = camera("Hall", (4.6, -3.6, 1.35), (-1.9, 8.0, 3.1), 25)
    camera("Inside the beam", (2.2, 7.6, 1.3), (-5.0, 6.3, 4.2), 22)
    camera("Along the arcade", (-3.2, -3.5, 1.7), (-1.9, 8.0, 2.6), 26)
    bpy.context.scene.camera = hall


def build():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps = FRAMES_PER_SECOND
    scene.render.resolution_x, scene.render.resolution_y = 1280, 720
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
    sky = material("Sky", (0.0, 0.0, 0.0), (0.80, 0.90, 1.0))

    build_floor(slab, dark)
    build_walls(stone, pale, shade)
    build_ceiling(shade, wood)
    build_arcade(stone, pale)
    build_columns(pale)
    build_tracery(iron)
    build_portal(pale, wood)
    build_pews(wood)
    build_censer(brass, iron)
    build_lantern(iron, glow)
    backdrop = Part(sky)
    backdrop.face(((-40, -60, -20), (-40, 80, -20), (-40, 80, 60), (-40, -60, 60)))
    backdrop.place("Sky")
    build_cameras()
    return build_lights()


def export(path, slides):
    plain = path + ".plain.glb"
    bpy.ops.export_scene.gltf(filepath=plain, export_format="GLB", export_extras=True, export_cameras=True,
                              export_lights=True, export_texcoords=True, export_yup=True, export_apply=True,
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
