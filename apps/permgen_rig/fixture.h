// The content of a fixture file, which an effect is tested with: plain data, not yet checked against the effect.
// apps/permgen_rig/README.md describes the file.
#pragma once

#include <rig/compare.h>
#include <tyndall/result.h>
#include <vulkan/vulkan_core.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace tyndall::rig {

/// Numbers in the file's order, and their nesting: [[1, 2], [3, 4]] has the shape {2, 2}, a
/// single number an empty one.
struct Numbers {
    std::vector<double> values;
    std::vector<std::size_t> shape;
};

struct ImageFile {
    std::string path;  ///< absolute, or from where the program runs
};

enum class Pattern { Constant, Checker, Gradient, Noise };

struct Generated {
    Pattern pattern = Pattern::Checker;
    int width = 64, height = 64;
    std::array<std::array<float, 4>, 2> colours{{{0.0f, 0.0f, 0.0f, 1.0f}, {1.0f, 1.0f, 1.0f, 1.0f}}};
    std::array<int, 2> cells{8, 8};  ///< of a checker
    std::uint32_t seed = 1;          ///< of noise
};

using TextureSource = std::variant<ImageFile, Generated>;

enum class Shape { Triangle, Quad, Cube, Sphere };

/// Vertices by semantic ("POSITION0"), each with 1 to 4 numbers; all of one count.
struct ExplicitGeometry {
    std::map<std::string, std::vector<std::vector<double>>> vertices;
    std::vector<std::uint32_t> indices;
};

struct Fixture {
    std::string path;  ///< of the file, for messages
    std::uint32_t width = 96, height = 96;
    VkFormat format = VK_FORMAT_R32G32B32A32_SFLOAT;
    Tolerance tolerance = Tolerance::Float;  ///< of goldens; follows from the format
    std::array<float, 4> clear{0.0f, 0.0f, 0.0f, 1.0f};
    bool depth = false;
    std::map<std::string, Numbers> constants;
    std::map<std::string, TextureSource> textures;
    std::variant<Shape, ExplicitGeometry> geometry = Shape::Quad;
};

/// Errors: one sentence that begins with the file and the place in it: "toon.json: constants.gTint: …".
Result<Fixture> readFixture(const std::string& path);

}  // namespace tyndall::rig
