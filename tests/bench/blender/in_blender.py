"""Runs inside Blender, as `run` starts it: draws every case with Cycles, and reads all pictures.

    blender -b --factory-startup --python in_blender.py -- JOB.json

The job names the cases and pictures. What it finds goes to the job's `found`: block means of each picture.
"""

import json
import math
import pathlib
import sys

import bpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import scene as shared  # noqa: E402


def nodes_of(block):
    """An empty node tree of a material, light or world, and a function that adds a node with these inputs."""
    block.use_nodes = True
    tree = block.node_tree
    tree.nodes.clear()

    def node(kind, **inputs):
        made = tree.nodes.new(kind)
        for name, value in inputs.items():
            made.inputs[name].default_value = value
        return made

    return tree, node


def lamp():
    """A point lamp of radius 0 whose nodes leave the beam's pyramid.

    A lamp of W watts sends W / (4 pi) W/sr in each direction. So one candela is one W/sr here: one unit for all cases,
    and nothing is fitted. (The glTF exporter's 683 lm/W would multiply both sides.)
    """
    light = bpy.data.lights.new("Lamp", "POINT")
    light.energy = 4.0 * math.pi * shared.CANDELA
    light.shadow_soft_size = 0.0
    tree, node = nodes_of(light)

    def math_node(operation, first, second=None):
        made = node("ShaderNodeMath")
        made.operation = operation
        for socket, value in zip(made.inputs, (first, second)):
            if isinstance(value, bpy.types.NodeSocket):
                tree.links.new(value, socket)
            elif value is not None:
                socket.default_value = value
        return made.outputs[0]

    # Of a lamp, the normal is the direction of the light, in the lamp's own space.
    direction = node("ShaderNodeSeparateXYZ")
    tree.links.new(node("ShaderNodeTexCoord").outputs["Normal"], direction.inputs[0])
    x, y, z = direction.outputs
    ahead = math_node("MULTIPLY", z, -1.0)
    inside = [math_node("LESS_THAN", math_node("ABSOLUTE", side), math_node("MULTIPLY", ahead, math.tan(half)))
              for side, half in zip((x, y), shared.BEAM_HALF_ANGLES)]
    emission, output = node("ShaderNodeEmission"), node("ShaderNodeOutputLight")
    tree.links.new(math_node("MULTIPLY", *inside), emission.inputs["Strength"])
    tree.links.new(emission.outputs[0], output.inputs[0])
    placed(light, shared.rows(shared.LAMP, shared.LAMP_TARGET))


def placed(data, matrix=None):
    made = bpy.data.objects.new(data.name, data)
    bpy.context.scene.collection.objects.link(made)
    if matrix:
        from mathutils import Matrix
        made.matrix_world = Matrix(matrix)
    return made


def mesh(name, corners, faces, material):
    made = bpy.data.meshes.new(name)
    made.from_pydata(corners, [], faces)
    made.materials.append(material)
    return placed(made)


def air():
    """A box of even air; returns what sets its density, anisotropy and albedo."""
    material = bpy.data.materials.new("Air")
    material.cycles.volume_sampling = "EQUIANGULAR"
    tree, node = nodes_of(material)
    scatter = node("ShaderNodeVolumeScatter", Color=(1.0, 1.0, 1.0, 1.0))
    absorb = node("ShaderNodeVolumeAbsorption", Color=(0.0, 0.0, 0.0, 1.0))
    both, output = node("ShaderNodeAddShader"), node("ShaderNodeOutputMaterial")
    tree.links.new(scatter.outputs[0], both.inputs[0])
    tree.links.new(absorb.outputs[0], both.inputs[1])
    tree.links.new(both.outputs[0], output.inputs["Volume"])
    b = shared.BOX
    mesh("Air", [(x, y, z) for x in (-b, b) for y in (-b, b) for z in (-b, b)],
         [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)], material)

    def fill(anisotropy, albedo):
        density = shared.density_of(albedo)
        scatter.inputs["Density"].default_value = density
        scatter.inputs["Anisotropy"].default_value = anisotropy
        # Scattering takes `density` from the light already.
        absorb.inputs["Density"].default_value = 0.0 if albedo is None else density / albedo - density

    return fill


def build(width, height, samples):
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.color_depth = "32"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", samples, 1
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = 0.0
    cycles.max_bounces = cycles.volume_bounces = 0  # light is scattered once
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1.0
    scene.world = bpy.data.worlds.new("Black")
    nodes_of(scene.world)

    black = bpy.data.materials.new("Black")
    tree, node = nodes_of(black)
    tree.links.new(node("ShaderNodeBsdfDiffuse", Color=(0.0, 0.0, 0.0, 1.0)).outputs[0],
                   node("ShaderNodeOutputMaterial").inputs["Surface"])
    mesh("Plate", shared.PLATE, [(0, 1, 2, 3)], black)

    camera = bpy.data.cameras.new("Eye")
    # Cycles starts view rays at clip_start: air before it takes no light.
    camera.sensor_fit, camera.clip_start, camera.clip_end = "HORIZONTAL", 1e-4, 1000.0
    camera.angle = 2.0 * math.atan(shared.CAMERA_HALF_WIDTH)
    scene.camera = placed(camera, shared.rows(shared.CAMERA, shared.CAMERA_TARGET))
    lamp()
    return air()


def pixels(path):
    """Width, height, and rows of the green channel from top to bottom."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    width, height = image.size
    green = image.pixels[:][1::image.channels]
    bpy.data.images.remove(image)
    return width, height, [green[row * width:(row + 1) * width] for row in reversed(range(height))]


def shrunk(path, across, along):
    """Means of `across` x `along` equal blocks, rows from top to bottom."""
    width, height, picture = pixels(path)
    if width % across or height % along:
        sys.exit(f"{path} has {width}x{height} pixels: {across}x{along} blocks do not divide it")
    w, h = width // across, height // along
    return [[math.fsum(v for row in picture[y * h:(y + 1) * h] for v in row[x * w:(x + 1) * w]) / (w * h)
             for x in range(across)] for y in range(along)]


def sheet(rows, path):
    """Rows of pictures, each a list of rows of values from 0 to 1, as one grey PNG."""
    gap = 2
    width = sum(len(picture[0]) + gap for picture in rows[0]) - gap
    lines = []
    for pictures in rows:
        for y in range(len(pictures[0])):
            line = []
            for picture in pictures:
                line += [*picture[y], *[1.0] * gap]
            lines.append(line[:width])
        lines += [[1.0] * width] * gap
    lines = lines[:-gap]
    image = bpy.data.images.new("Sheet", width, len(lines))
    image.pixels = [c for line in reversed(lines) for v in line for c in (v, v, v, 1.0)]
    image.filepath_raw, image.file_format = str(path), "PNG"
    image.save()


def main():
    job_file = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
    job = json.loads(job_file.read_text())
    fill = build(job["width"], job["height"], job["samples"])
    found, shown = [], []
    for case in job["cases"]:
        fill(case["anisotropy"], case["albedo"])
        bpy.context.scene.render.filepath = case["blender"]
        bpy.ops.render.render(write_still=True)
        found.append({who: shrunk(case[who], *job["blocks"]) for who in ("blender", "reference", "render")})
        if case["shown"]:
            pair = [shrunk(case[who], job["width"], job["height"]) for who in ("blender", "render")]
            white = sorted(v for row in pair[1] for v in row)[-job["width"] * job["height"] // 20]  # around the lamp
            shown.append([[[min(v / white, 1.0) ** (1.0 / 2.2) for v in row] for row in one] for one in pair])
    sheet(shown, job["sheet"])
    pathlib.Path(job["found"]).write_text(json.dumps(found))


main()
