// Small glTF files made in code, so that every test shows its scene.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace tyndall::test {

/// A .glb under construction; tests may change the JSON freely.
struct Glb {
    nlohmann::json json;
    std::vector<unsigned char> binary;

    /// Appends bytes as a buffer view of their own and returns its index.
    std::size_t addView(std::span<const unsigned char> bytes);
    /// Appends floats as an accessor of `type` ("VEC3", ...) and returns its index.
    std::size_t addFloats(const std::vector<float>& values, const std::string& type);
    std::size_t addIndices(const std::vector<std::uint16_t>& values);
    /// Appends an RGBA image as a PNG with a texture of its own; returns the texture's index.
    std::size_t addTexture(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgba);
    /// A flat square of the given half side, facing +Z in its own space; returns the mesh's index.
    std::size_t addSquare(float halfSide);
    std::size_t addNode(nlohmann::json node);

    std::vector<unsigned char> bytes() const;
};

/// A white wall of 8 x 8 m at z = -5 facing the origin, a camera and a spot light of 20 degrees half angle,
/// 100 cd, both at the origin and looking along -Z; node 0 is the wall, 1 the camera "Eye", 2 the lamp "Lamp".
Glb wallScene();

/// A new file in the test's own folder, with these bytes; the folder is removed when the program ends.
std::string writeScene(const Glb& glb, const std::string& name = "scene.glb");
std::string writeBytes(std::span<const unsigned char> bytes, const std::string& name);
/// An unused path in the test's own folder.
std::string freshPath(const std::string& name);

/// An RGBA image as PNG, uncompressed.
std::vector<unsigned char> encodePng(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgba);

}  // namespace tyndall::test
