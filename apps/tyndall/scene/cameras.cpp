#include "cameras.h"

#include <cmath>
#include <numbers>

#include "pose.h"

namespace tyndall::app {
Result<Camera> readCamera(const tinygltf::Model& model, std::size_t node, const glm::dmat4& pose) {
    const tinygltf::Camera& source = model.cameras[static_cast<std::size_t>(model.nodes[node].camera)];
    Camera camera;
    camera.name = !model.nodes[node].name.empty() ? model.nodes[node].name : source.name;
    const std::string place = fmt::format("camera \"{}\"", camera.name);
    auto rigid = rigidPart(pose, place);
    if (!rigid) return tl::unexpected(rigid.error());
    camera.worldFromCamera = *rigid;

    if (source.type == "perspective") {
        camera.verticalFov = source.perspective.yfov;
        if (!(camera.verticalFov > 0.0 && camera.verticalFov < std::numbers::pi))
            return fail("{} has a vertical field of view of {:g} degrees; it must lie between 0 and 180", place,
                        camera.verticalFov * 180.0 / std::numbers::pi);
        camera.nearPlane = source.perspective.znear;
        if (source.perspective.zfar != 0.0) camera.farPlane = source.perspective.zfar;
    } else if (source.type == "orthographic") {
        camera.orthographic = true;
        camera.halfHeight = std::abs(source.orthographic.ymag);
        for (const double size : {source.orthographic.xmag, source.orthographic.ymag})
            if (!(std::abs(size) > 0.0))
                return fail("{} sees a width or a height of 0; give its orthographic scale a size", place);
        // glTF allows an orthographic near plane at the eye; the slices need some distance from it.
        camera.nearPlane = source.orthographic.znear == 0.0 ? 1e-3 : source.orthographic.znear;
        camera.farPlane = source.orthographic.zfar;
    } else {
        return fail("{} is of type \"{}\"; only perspective and orthographic cameras exist", place, source.type);
    }
    if (!(camera.nearPlane > 0.0))
        return fail("{} has its near plane at {:g} m; move it in front of the eye, above 0", place, camera.nearPlane);
    if (!(camera.farPlane > camera.nearPlane))
        return fail("{} has its near plane ({:g} m) beyond its far plane ({:g} m); exchange them", place,
                    camera.nearPlane, camera.farPlane);
    return camera;
}

}  // namespace tyndall::app
