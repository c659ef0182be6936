#include "pose.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "animation.h"

namespace tyndall::app {
namespace {

glm::dmat4 localPose(const tinygltf::Node& node, const AnimatedNode* animated) {
    if (node.matrix.size() == 16 && animated == nullptr) return glm::make_mat4(node.matrix.data());
    glm::dvec3 translation(0.0), scale(1.0);
    glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
    if (node.translation.size() == 3) translation = glm::make_vec3(node.translation.data());
    if (node.scale.size() == 3) scale = glm::make_vec3(node.scale.data());
    if (node.rotation.size() == 4) {
        const std::vector<double>& r = node.rotation;
        const glm::dquat given(r[3], r[0], r[1], r[2]);
        if (glm::length(given) > 0.0) rotation = glm::normalize(given);
    }
    if (animated != nullptr) {
        translation = animated->translation.value_or(translation);
        rotation = animated->rotation.value_or(rotation);
        scale = animated->scale.value_or(scale);
    }
    return glm::translate(glm::dmat4(1.0), translation) * glm::mat4_cast(rotation) * glm::scale(glm::dmat4(1.0), scale);
}

bool finite(const glm::dmat4& matrix) {
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(glm::value_ptr(matrix)[i])) return false;
    return true;
}

std::vector<int> rootNodes(const tinygltf::Model& model) {
    if (!model.scenes.empty()) return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
    std::vector<bool> child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int below : node.children) child[static_cast<std::size_t>(below)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < child.size(); ++i)
        if (!child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

}  // namespace

std::string nodeName(const tinygltf::Model& model, std::size_t node) {
    const std::string& name = model.nodes[node].name;
    return name.empty() ? fmt::format("node {}", node) : fmt::format("node \"{}\"", name);
}

Result<std::vector<std::optional<glm::dmat4>>> worldPoses(const tinygltf::Model& model, double time) {
    const auto animated = sampleAnimations(model, time);
    if (!animated) return tl::unexpected(animated.error());

    std::vector<std::optional<glm::dmat4>> poses(model.nodes.size());
    std::vector<std::pair<std::size_t, glm::dmat4>> open;
    for (const int root : rootNodes(model)) open.emplace_back(static_cast<std::size_t>(root), glm::dmat4(1.0));
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        const auto motion = animated->find(node);
        const glm::dmat4 pose =
            parent * localPose(model.nodes[node], motion == animated->end() ? nullptr : &motion->second);
        if (!finite(pose))
            return fail("{} has a transform that is not finite; reset it and export the file again",
                        nodeName(model, node));
        poses[node] = pose;
        for (const int child : model.nodes[node].children) open.emplace_back(static_cast<std::size_t>(child), pose);
    }
    return poses;
}

Result<glm::dmat4> rigidPart(const glm::dmat4& pose, const std::string& place) {
    const glm::dvec3 z(pose[2]), y(pose[1]), x(pose[0]);
    const double zLength = glm::length(z);
    const glm::dvec3 back = z / zLength;
    const glm::dvec3 upright = y - back * glm::dot(back, y);
    const double yLength = glm::length(upright);
    if (!(glm::length(x) > 0.0) || !(zLength > 0.0) || !(yLength > 1e-12 * glm::length(y)) ||
        !std::isfinite(zLength * yLength))
        return fail("{} is scaled to nothing, so it has no direction; give it a scale other than 0", place);
    const glm::dvec3 up = upright / yLength;
    return glm::dmat4(glm::dvec4(glm::cross(up, back), 0.0), glm::dvec4(up, 0.0), glm::dvec4(back, 0.0), pose[3]);
}

}  // namespace tyndall::app
