// A scene as the program draws it: plain data, read from glTF at one time of its animations.
#pragma once

#include <kit/image/image.h>
#include <tyndall/light.h>
#include <tyndall/meshes.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace tyndall::app {

struct Vertex {
    glm::vec3 position{0.0f};  ///< metres, in mesh space
    glm::vec3 normal{0.0f};    ///< unit length
    glm::vec2 uv{0.0f};        ///< (0, 0) is the texture's top left corner
};
static_assert(sizeof(Vertex) == 32);

struct Material {
    glm::vec3 baseColour{1.0f};              ///< linear reflectance, multiplies the texture
    glm::vec3 emissive{0.0f};                ///< radiance
    std::optional<std::size_t> baseTexture;  ///< index into Scene::images
    bool doubleSided = false;
};

/// One glTF primitive as a triangle list.
struct Mesh {
    std::string name;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    Material material;
};

struct Camera {
    std::string name;
    glm::dmat4 worldFromCamera{1.0};  ///< rigid, looks along -Z, +Y up
    bool orthographic = false;
    double verticalFov = 0.0;  ///< radians, perspective only
    double halfHeight = 0.0;   ///< metres, orthographic only; the width follows from the aspect ratio
    double nearPlane = 0.1;    ///< metres
    double farPlane = std::numeric_limits<double>::infinity();
};

/// Half angles of a lamp's cone, radians: full light within `inner`, none beyond `outer`.
struct ConeAngles {
    double inner = 0.0, outer = 0.0;
};

struct SceneLight {
    Light light;
    std::optional<std::size_t> cookie;  ///< index into Scene::images; cone falloff is baked in
    std::optional<ConeAngles> cone;     ///< the baked falloff
    std::optional<std::size_t> slide;   ///< index into Scene::slides: the image that the cone was baked into, if any
    std::optional<std::size_t> noise;   ///< index into Scene::images
    bool movingShadow = false;          ///< the shadow map is drawn again each frame
};

/// A light that makes no shafts, and why.
struct IgnoredLight {
    std::string name;
    std::string reason;
};

/// Axis-aligned box in world space; empty while minimum > maximum.
struct Bounds {
    glm::dvec3 minimum{std::numeric_limits<double>::infinity()};
    glm::dvec3 maximum{-std::numeric_limits<double>::infinity()};
    bool empty() const { return minimum.x > maximum.x; }
};

struct Scene {
    std::vector<Image> images;  ///< RGBA, used for drawing; shared by lights and meshes
    std::vector<Image> slides;  ///< RGBA, sources of baked cones; not used for drawing
    std::vector<Mesh> meshes;
    std::vector<MeshInstance> instances;  ///< of meshes
    std::vector<Camera> cameras;
    std::vector<SceneLight> lights;
    std::vector<IgnoredLight> ignoredLights;
    std::vector<std::string> warnings;  ///< one sentence each
    Bounds bounds;                      ///< of all instances
};

}  // namespace tyndall::app
