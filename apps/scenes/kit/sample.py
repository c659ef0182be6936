"""Common steps of all sample scenes: clear, add cameras and lamps, export, add the lamps' pictures."""

import math
import os
import sys

import bpy
from mathutils import Vector

import glb
from kit.geometry import place

LUMEN_PER_WATT = 683  # the exporter turns Blender's watts into candela with it, spread over the whole sphere


def begin(frames_per_second=24):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    render = bpy.context.scene.render
    render.fps = frames_per_second
    render.resolution_x, render.resolution_y = 1280, 720


def looking(direction):
    """Rotation that turns a camera or lamp, which look along -Z with Y up, into `direction`."""
    return Vector(direction).to_track_quat("-Z", "Y")


def camera(name, eye, target, lens, far=100.0):
    """`lens`: focal length in mm on a sensor 36 mm wide; `far`: metres."""
    data = bpy.data.cameras.new(name)
    data.lens = lens
    data.clip_start, data.clip_end = 0.1, far
    return place(name, data, eye, looking(Vector(target) - Vector(eye)).to_euler())


def spot(name, location, direction, colour, candela, cone_degrees, blend, tyndall):
    """A lamp with its extras.tyndall, in which cookie and noise are names of pictures that are passed to
    export()."""
    light = bpy.data.lights.new(name, "SPOT")
    light.color = colour
    light.energy = candela * 4 * math.pi / LUMEN_PER_WATT
    light.spot_size = math.radians(cone_degrees)
    light.spot_blend = blend
    light.shadow_soft_size = 0
    item = place(name, light, location, looking(direction).to_euler())
    item["tyndall"] = tyndall
    return item


def export(path, pictures):
    """Writes the scene. `pictures`: PNG bytes by name; each picture that a lamp names is in the file once."""
    plain = path + ".part.glb"  # the exporter requires the extension
    bpy.ops.export_scene.gltf(filepath=plain, export_format="GLB", export_extras=True, export_cameras=True,
                              export_lights=True, export_texcoords=True, export_yup=True, export_apply=True,
                              export_animations=True)
    document, binary = glb.read(plain)
    os.remove(plain)
    index = {}

    def texture(name):
        if name not in index:
            index[name] = glb.add_texture(document, binary, name, pictures[name])
        return index[name]

    for node in document["nodes"]:
        settings = node.get("extras", {}).get("tyndall", {})
        if "cookie" in settings:
            settings["cookie"] = texture(settings["cookie"])
        if "noise" in settings:
            settings["noise"]["texture"] = texture(settings["noise"]["texture"])
    glb.write(path, document, binary)


def run(build):
    """The main function of a scene's script: `build()` makes the scene and returns its pictures."""
    script = os.path.basename(sys.modules["__main__"].__file__)
    arguments = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    if len(arguments) != 1:
        sys.exit(f"usage: blender --background --python-exit-code 1 --python {script} -- OUTPUT.glb")
    output = os.path.abspath(arguments[0])
    if not os.access(os.path.dirname(output), os.W_OK) or os.path.isdir(output):
        sys.exit(f"{script}: {output} cannot be written; name a file in a folder that can be written to")
    export(output, build())
