"""The scene that both programs draw: one lamp in even air, one black plate in its beam.

Metres, Y up. Lamp and camera look along their own -Z. Blender takes these coordinates as they are: its own "Z is up" is
no more than a habit of its user interface.
"""

import base64
import json
import math
import struct

LAMP, LAMP_TARGET = (-3.0, 0.6, -4.0), (2.0, -0.2, 4.0)  # the beam comes from behind and passes the eye on its right
CAMERA, CAMERA_TARGET = (0.0, 0.0, 6.0), (0.0, 0.0, 0.0)
BEAM_HALF_ANGLES = math.radians(14.0), math.radians(9.0)  # of a pyramid with hard edges, horizontal and vertical
NEAR, FAR = 0.02, 25.0  # metres along the beam's axis; the far end is behind the eye
CAMERA_HALF_WIDTH = math.tan(math.radians(30.0))  # of the picture, a metre from the eye
CANDELA = 1000.0
BOX = 60.0  # half the side of Blender's box of air: it holds lamp, eye and all that is seen
PLATE = [(-0.6, -0.25, 0.2), (0.1, -0.25, -0.1), (0.1, 0.35, -0.1), (-0.6, 0.35, 0.2)]

# Scattering coefficients, 1/m. Cycles has no air that scatters without extinction. Where a case gives no albedo, the air is
# so thin that Cycles' extinction takes less than 0.0003 of the light; a pixel is proportional to the density.
DENSITY, THIN = 0.08, 1e-5


def look_at(eye, target):
    """Columns x, y, z of the axes of what looks from `eye` to `target` along its -Z."""
    def unit(v):
        length = math.sqrt(sum(c * c for c in v))
        return tuple(c / length for c in v)

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    z = unit(tuple(a - b for a, b in zip(eye, target)))
    x = unit(cross((0.0, 1.0, 0.0), z))
    return x, cross(z, x), z


def rows(eye, target):
    """The same as the rows of a 4 x 4 matrix, with the place."""
    x, y, z = look_at(eye, target)
    return [[x[i], y[i], z[i], eye[i]] for i in range(3)] + [[0.0, 0.0, 0.0, 1.0]]


def column_major(matrix):
    return [matrix[row][column] for column in range(4) for row in range(4)]


def lamp_pixel(width, height):
    """Where the picture shows the lamp."""
    x, y, z = look_at(CAMERA, CAMERA_TARGET)
    way = [a - b for a, b in zip(LAMP, CAMERA)]
    right, up, ahead = (sum(a * b for a, b in zip(way, axis)) for axis in (x, y, z))
    across = right / -ahead / CAMERA_HALF_WIDTH
    along = up / -ahead / CAMERA_HALF_WIDTH * width / height
    return 0.5 * width * (1.0 + across), 0.5 * height * (1.0 - along)


def density_of(albedo):
    return THIN if albedo is None else DENSITY


def gltf(anisotropy, albedo, aspect):
    """The scene as glTF, with the settings of docs/scenes.md."""
    settings = {"shape": "frustum", "fov": [2.0 * math.degrees(half) for half in BEAM_HALF_ANGLES], "near": NEAR,
                "far": FAR, "density": density_of(albedo), "anisotropy": anisotropy}
    if albedo is not None:
        settings["albedo"] = albedo
    binary = struct.pack("<12f", *(c for corner in PLATE for c in corner)) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    return json.dumps({
        "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual"], "scene": 0,
        "scenes": [{"nodes": [0, 1, 2]}],
        "nodes": [
            {"name": "Eye", "camera": 0, "matrix": column_major(rows(CAMERA, CAMERA_TARGET))},
            {"name": "Lamp", "matrix": column_major(rows(LAMP, LAMP_TARGET)), "extras": {"tyndall": settings},
             "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"name": "Plate", "mesh": 0}],
        "cameras": [{"type": "perspective", "perspective": {
            "yfov": 2.0 * math.atan(CAMERA_HALF_WIDTH / aspect), "aspectRatio": aspect, "znear": 0.01, "zfar": 60.0}}],
        "extensions": {"KHR_lights_punctual": {"lights": [{
            "type": "spot", "intensity": CANDELA, "spot": {"outerConeAngle": max(BEAM_HALF_ANGLES)}}]}},
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"doubleSided": True, "pbrMetallicRoughness": {"baseColorFactor": [0.0, 0.0, 0.0, 1.0]}}],
        "buffers": [{"byteLength": len(binary),
                     "uri": "data:application/octet-stream;base64," + base64.b64encode(binary).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
             "min": [min(axis) for axis in zip(*PLATE)], "max": [max(axis) for axis in zip(*PLATE)]},
            {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}]})
