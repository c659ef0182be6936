// The images of a scene, each loaded or baked once and shared by its users.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "document.h"
#include "scene.h"
#include "texture.h"

namespace tyndall::app {

/// Fills Scene::images and Scene::slides on request. Keeps references to both arguments.
class SharedImages {
public:
    SharedImages(const tinygltf::Model& model, Scene& scene) : model_(model), scene_(scene) {}

    /// Index into Scene::images. `user` names the user in messages.
    Result<std::size_t> texture(int texture, Encoding encoding, const std::string& user);

    /// Index into Scene::slides of a cookie that a cone is baked into.
    Result<std::size_t> slide(int texture, const std::string& user);

    /// Index into Scene::images: the falloff of `cone`, baked into the slide if there is one.
    std::size_t cone(const ConeAngles& cone, std::optional<std::size_t> slide);

private:
    struct ConeKey {
        double inner, outer;
        std::optional<std::size_t> slide;
        auto operator<=>(const ConeKey&) const = default;
    };

    const tinygltf::Model& model_;
    Scene& scene_;
    std::map<std::pair<std::size_t, Encoding>, std::size_t> textures_;  // by image of the file
    std::map<std::size_t, std::size_t> slides_;                         // by image of the file
    std::map<ConeKey, std::size_t> cones_;
};

}  // namespace tyndall::app
