#include "load_scene.h"

#include <map>

#include "cameras.h"
#include "lights.h"
#include "meshes.h"
#include "pose.h"
#include "shared_images.h"

namespace tyndall::app {
namespace {

class Loader {
public:
    Loader(const Document& document, std::vector<std::optional<glm::dmat4>> poses)
        : document_(document), poses_(std::move(poses)) {}

    Result<Scene> load() {
        for (auto step : {&Loader::readMeshes, &Loader::readCameras, &Loader::readLights})
            if (auto done = (this->*step)(); !done) return tl::unexpected(done.error());
        return std::move(scene_);
    }

private:
    Result<void> readMeshes() {
        std::map<int, std::pair<std::size_t, std::size_t>> known;  // glTF mesh: first and last of Scene::meshes
        const ColourTexture colour = [this](int texture, const std::string& user) {
            return images_.texture(texture, Encoding::Srgb, user);
        };
        for (std::size_t node = 0; node < model().nodes.size(); ++node) {
            const int mesh = model().nodes[node].mesh;
            if (mesh < 0 || !poses_[node]) continue;
            if (model().nodes[node].skin >= 0)
                scene_.warnings.push_back(nodeName(model(), node) + " has a skin; it is drawn in its rest shape");
            if (!known.contains(mesh)) {
                auto read = readMesh(model(), static_cast<std::size_t>(mesh), colour, scene_.warnings);
                if (!read) return tl::unexpected(read.error());
                const std::size_t first = scene_.meshes.size();
                for (Mesh& part : *read) scene_.meshes.push_back(std::move(part));
                known[mesh] = {first, scene_.meshes.size()};
            }
            for (std::size_t part = known[mesh].first; part < known[mesh].second; ++part) {
                scene_.instances.push_back({part, *poses_[node]});
                extend(scene_.meshes[part], *poses_[node]);
            }
        }
        return {};
    }

    void extend(const Mesh& mesh, const glm::dmat4& pose) {
        for (const std::uint32_t index : mesh.indices) {
            const glm::dvec3 point(pose * glm::dvec4(glm::dvec3(mesh.vertices[index].position), 1.0));
            scene_.bounds.minimum = glm::min(scene_.bounds.minimum, point);
            scene_.bounds.maximum = glm::max(scene_.bounds.maximum, point);
        }
    }

    Result<void> readCameras() {
        for (std::size_t node = 0; node < model().nodes.size(); ++node) {
            if (model().nodes[node].camera < 0 || !poses_[node]) continue;
            auto camera = readCamera(model(), node, *poses_[node]);
            if (!camera) return tl::unexpected(camera.error());
            scene_.cameras.push_back(std::move(*camera));
        }
        if (scene_.cameras.empty()) return fail("holds no camera; add one and export the file with cameras");
        return {};
    }

    Result<void> readLights() {
        std::vector<std::optional<std::size_t>> parents(model().nodes.size());
        for (std::size_t node = 0; node < model().nodes.size(); ++node)
            for (const int child : model().nodes[node].children) parents[static_cast<std::size_t>(child)] = node;

        for (std::size_t node = 0; node < model().nodes.size(); ++node) {
            if (!poses_[node]) continue;
            const std::optional<std::size_t> lamp = lampOf(node);
            if (!lamp) continue;
            const std::string& type = model().lights[*lamp].type;
            if (type != "spot") {
                ignore(node, type);
                continue;
            }
            auto read = readSpotLight(document_, node, parents[node], *poses_[node], scene_.bounds, scene_.warnings);
            if (!read) return tl::unexpected(read.error());
            if (auto done = keep(std::move(*read)); !done) return tl::unexpected(done.error());
        }
        if (scene_.lights.empty() && scene_.ignoredLights.empty())
            return fail("holds no light; add a spot light and export the file with punctual lights");
        return {};
    }

    std::optional<std::size_t> lampOf(std::size_t node) const {
        const nlohmann::json& source = document_.json["nodes"][node];
        const nlohmann::json::json_pointer where("/extensions/KHR_lights_punctual/light");
        if (!source.contains(where)) return std::nullopt;
        return source[where].get<std::size_t>();
    }

    void ignore(std::size_t node, const std::string& type) {
        const bool parallel = type == "directional";
        scene_.ignoredLights.push_back(
            {nodeName(model(), node),
             parallel
                 ? "a directional light has no position to project from, so it makes no shafts and lights no surface; "
                   "use a spot light far away"
                 : fmt::format("a {} light shines in all directions, so it makes no shafts and lights no surface; "
                               "use a spot light",
                               type)});
    }

    Result<void> keep(ReadLight read) {
        SceneLight& light = read.light;
        const std::string place = fmt::format("light \"{}\", extras.tyndall.", light.light.name);
        if (read.noiseTexture) {
            auto noise = images_.texture(*read.noiseTexture, Encoding::Linear, place + "noise");
            if (!noise) return tl::unexpected(noise.error());
            light.noise = *noise;
        }
        if (read.cookieTexture) {
            auto picture = light.cone ? images_.slide(*read.cookieTexture, place + "cookie")
                                      : images_.texture(*read.cookieTexture, Encoding::Srgb, place + "cookie");
            if (!picture) return tl::unexpected(picture.error());
            (light.cone ? light.slide : light.cookie) = *picture;
        }
        if (light.cone) light.cookie = images_.cone(*light.cone, light.slide);
        scene_.lights.push_back(std::move(light));
        return {};
    }

    const tinygltf::Model& model() const { return document_.model; }

    const Document& document_;
    std::vector<std::optional<glm::dmat4>> poses_;
    Scene scene_;
    SharedImages images_{document_.model, scene_};
};

}  // namespace

Result<Scene> loadScene(const std::string& path, double time) {
    auto document = readDocument(path);
    if (!document) return tl::unexpected(document.error());
    auto poses = worldPoses(document->model, time);
    if (!poses) return passOn(poses.error(), path);
    auto scene = Loader(*document, std::move(*poses)).load();
    if (!scene) return passOn(scene.error(), path);
    if (!document->warnings.empty()) scene->warnings.push_back(document->warnings);
    return scene;
}

}  // namespace tyndall::app
