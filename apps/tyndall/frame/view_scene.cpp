#include "view_scene.h"

#include "../scene/load_scene.h"
#include "scene_view.h"

namespace tyndall::app {

Result<ViewedScene> viewScene(const ViewOptions& options) {
    auto scene = loadScene(options.scene, options.time);
    if (!scene) return tl::unexpected(scene.error());
    ViewedScene viewed;
    viewed.scene = std::move(*scene);
    auto camera = chooseCamera(viewed.scene, options.camera);
    if (!camera) return tl::unexpected(camera.error());
    viewed.camera = *camera;
    viewed.view = viewFrom(**camera, options.size);
    for (const SceneLight& light : viewed.scene.lights) viewed.lights.push_back(light.light);
    viewed.instancesInLight = instancesByLight(viewed.scene, viewed.lights);
    return viewed;
}

}  // namespace tyndall::app
