"""Adds textures that no material uses to a .glb, and names them in a light's settings for Tyndall.

Blender exports only images that a material uses, so cookies and noise must be added afterwards.

    python3 glb.py IN.glb OUT.glb --light NODE [--cookie PNG] [--noise PNG] [--set KEY=JSON]...
"""

import argparse
import json
import os
import struct
import sys

MAGIC, JSON_CHUNK, BIN_CHUNK = 0x46546C67, 0x4E4F534A, 0x004E4942  # "glTF", "JSON", "BIN\0": glTF 2.0, section 4.4


def read(path):
    """Returns the JSON document and the bytes of its binary chunk."""
    with open(path, "rb") as file:
        data = file.read()
    try:
        magic, version, length = struct.unpack_from("<III", data)
        if magic != MAGIC or version != 2 or length != len(data):
            raise ValueError
        chunks, at = {}, 12
        while at < length:
            size, kind = struct.unpack_from("<II", data, at)
            chunks[kind] = data[at + 8:at + 8 + size]
            at += 8 + size
        document = json.loads(chunks[JSON_CHUNK])
    except (struct.error, KeyError, ValueError):
        raise ValueError(f"{path} is not a complete glTF 2.0 binary file; export the scene as .glb again") from None
    used = document["buffers"][0]["byteLength"] if document.get("buffers") else 0
    return document, bytearray(chunks.get(BIN_CHUNK, b"")[:used])


def write(path, document, binary):
    """Writes a temporary file and renames it, so that a failure leaves the old file."""
    if binary:
        document.setdefault("buffers", [{}])[0]["byteLength"] = len(binary)
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), JSON_CHUNK) + text
    if binary:
        padded = bytes(binary) + b"\0" * (-len(binary) % 4)
        chunks += struct.pack("<II", len(padded), BIN_CHUNK) + padded
    with open(path + ".part", "wb") as file:
        file.write(struct.pack("<III", MAGIC, 2, 12 + len(chunks)) + chunks)
    os.replace(path + ".part", path)


def add_texture(document, binary, name, png):
    """Appends a PNG as image and texture; returns the texture's index."""
    binary.extend(b"\0" * (-len(binary) % 4))
    views = document.setdefault("bufferViews", [])
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(png)})
    binary.extend(png)
    images = document.setdefault("images", [])
    images.append({"name": name, "mimeType": "image/png", "bufferView": len(views) - 1})
    textures = document.setdefault("textures", [])
    textures.append({"name": name, "source": len(images) - 1})
    return len(textures) - 1


def settings_of(document, node_name):
    """The `extras.tyndall` of the node that carries the light; made if absent.

    Some exporters put the light on a child of the node with its name; then this returns the child's.
    """
    nodes = document.get("nodes", [])

    def has_light(node):
        return "KHR_lights_punctual" in node.get("extensions", {})

    for node in nodes:
        if node.get("name") != node_name:
            continue
        for bearer in [node] + [nodes[i] for i in node.get("children", [])]:
            if has_light(bearer):
                parent_settings = node.get("extras", {}).pop("tyndall", {}) if bearer is not node else {}
                return bearer.setdefault("extras", {}).setdefault("tyndall", parent_settings)
    lights = ", ".join(repr(n.get("name")) for n in nodes if has_light(n)) or "none"
    raise ValueError(f"there is no light on a node named {node_name!r}; lights here: {lights}; name one of them")


def main(arguments):
    parser = argparse.ArgumentParser(description="Gives a light of a .glb its cookie, noise and other settings.")
    parser.add_argument("input")
    parser.add_argument("output")
    parser.add_argument("--light", required=True, metavar="NODE")
    parser.add_argument("--cookie", metavar="PNG")
    parser.add_argument("--noise", metavar="PNG")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=JSON", help="for example density=0.03")
    options = parser.parse_args(arguments)

    document, binary = read(options.input)
    settings = settings_of(document, options.light)
    for entry in options.set:
        key, _, value = entry.partition("=")
        try:
            settings[key] = json.loads(value)
        except ValueError:
            raise ValueError(f"--set {entry}: what stands after = must be JSON; put a word in double quotes") from None
    if options.cookie:
        with open(options.cookie, "rb") as file:
            settings["cookie"] = add_texture(document, binary, "Cookie", file.read())
    if options.noise:
        with open(options.noise, "rb") as file:
            settings.setdefault("noise", {})["texture"] = add_texture(document, binary, "Noise", file.read())
    write(options.output, document, binary)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (OSError, ValueError) as error:
        sys.exit(f"glb.py: {error}")
