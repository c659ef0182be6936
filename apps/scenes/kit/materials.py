"""Surfaces: a colour, glowing or not, with or without the grain of stone."""

import os
import tempfile

import bpy


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
        sockets = {socket.identifier: socket for socket in [*tint.inputs, *tint.outputs]}
        sockets["Factor_Float"].default_value = 1.0
        sockets["B_Color"].default_value = (*colour, 1)
        made.node_tree.links.new(picture.outputs["Color"], sockets["A_Color"])
        made.node_tree.links.new(sockets["Result_Color"], shader.inputs["Base Color"])
    if emission:
        shader.inputs["Emission"].default_value = (*emission, 1)
        shader.inputs["Emission Strength"].default_value = 1.0
    made.use_backface_culling = True
    return made
