#include "reference_scene.h"

#include <glm/gtc/packing.hpp>

#include "read_back.h"
#include "scene_renderer.h"

namespace tyndall::app {
namespace {

/// The device's values: its textures are half floats.
Image asUploaded(Image image) {
    for (float& value : image.values) value = glm::unpackHalf1x16(glm::packHalf1x16(value));
    return image;
}

study::ReferenceScene commonPart(const ViewedScene& viewed, const ViewOptions& options, study::Mode mode) {
    study::ReferenceScene scene;
    scene.mode = mode;
    scene.view = viewed.view;
    scene.width = static_cast<int>(options.size.width);
    scene.height = static_cast<int>(options.size.height);
    scene.time = options.time;
    const bool hardware = mode == study::Mode::Hardware;
    const auto textureOf = [hardware](const Image& image) { return hardware ? asUploaded(image) : image; };
    for (std::size_t i = 0; i < viewed.lights.size(); ++i) {
        const SceneLight& source = viewed.scene.lights[i];
        study::ReferenceLight light;
        light.light = viewed.lights[i];
        if (light.light.cookie && source.cone && !hardware) {
            light.cone = study::Cone{source.cone->inner, source.cone->outer};
            light.light.cookie = source.slide.has_value();
            if (source.slide) light.cookie = textureOf(viewed.scene.slides[*source.slide]);
        } else if (light.light.cookie) {
            light.cookie = textureOf(viewed.scene.images[*source.cookie]);
        }
        if (source.noise) light.noise = textureOf(viewed.scene.images[*source.noise]);
        scene.lights.push_back(std::move(light));
    }
    return scene;
}

void addTriangles(const Mesh& mesh, const glm::dmat4& worldFromMesh, std::vector<study::Triangle>& triangles) {
    const bool mirrored = glm::determinant(glm::dmat3(worldFromMesh)) < 0.0;
    const auto corner = [&](std::size_t index) {
        return glm::dvec3(worldFromMesh * glm::dvec4(glm::dvec3(mesh.vertices[mesh.indices[index]].position), 1.0));
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles.push_back(
            {corner(i), corner(mirrored ? i + 2 : i + 1), corner(mirrored ? i + 1 : i + 2), mesh.material.doubleSided});
}

study::Image depthTexture(int width, int height, std::vector<float> values) {
    return {width, height, 1, std::move(values)};
}

}  // namespace

study::ReferenceScene idealScene(const ViewedScene& viewed, const ViewOptions& options) {
    study::ReferenceScene scene = commonPart(viewed, options, study::Mode::Ideal);
    for (const MeshInstance& instance : viewed.scene.instances)
        addTriangles(viewed.scene.meshes[instance.mesh], instance.worldFromMesh, scene.triangles);
    return scene;
}

Result<study::ReferenceScene> hardwareScene(const headless::Device& device, const ViewedScene& viewed,
                                            const ViewOptions& options, std::uint32_t shadowSize) {
    study::ReferenceScene scene = commonPart(viewed, options, study::Mode::Hardware);
    auto renderer = SceneRenderer::create(device, viewed.scene);
    if (!renderer) return tl::unexpected(renderer.error());
    const auto lighting = allLights(viewed.lights, viewed.instancesInLight);
    if (auto drawn = renderer->drawSurfaces(viewed, lighting, options.size, shadowSize, false); !drawn)
        return tl::unexpected(drawn.error());
    std::vector<std::size_t> shadowed;
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (scene.lights[i].light.shadow) shadowed.push_back(i);
    if (auto drawn = renderer->drawShadowMaps(viewed, shadowed, shadowSize, false); !drawn)
        return tl::unexpected(drawn.error());
    auto depth = readDepth(device, renderer->targets().depth, VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL);
    if (!depth) return tl::unexpected(depth.error());
    scene.depth = depthTexture(scene.width, scene.height, std::move(*depth));
    for (const std::size_t i : shadowed) {
        auto map = readDepth(device, *renderer->shadowMaps().image(i), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
        if (!map) return tl::unexpected(map.error());
        const int side = static_cast<int>(shadowSize);
        scene.lights[i].shadowMap = depthTexture(side, side, std::move(*map));
    }
    return scene;
}

}  // namespace tyndall::app
