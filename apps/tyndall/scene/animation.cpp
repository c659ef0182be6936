#include "animation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "accessor.h"

namespace tyndall::app {
namespace {

struct Track {
    std::vector<double> times;
    std::vector<double> values;
    std::size_t components;
    std::string interpolation;
};

using Value = std::array<double, 4>;

/// The key's value. A cubic spline stores three values for each key: `part` 0 is the incoming tangent, 1 the value
/// and 2 the outgoing tangent.
Value key(const Track& track, std::size_t index, std::size_t part = 1) {
    const std::size_t element = track.interpolation == "CUBICSPLINE" ? 3 * index + part : index;
    Value value{};
    for (std::size_t c = 0; c < track.components; ++c) value[c] = track.values[element * track.components + c];
    return value;
}

glm::dquat quaternion(const Value& v) {
    const glm::dquat q(v[3], v[0], v[1], v[2]);
    const double length = glm::length(q);
    return length > 0.0 ? q / length : glm::dquat(1.0, 0.0, 0.0, 0.0);
}

Value sample(const Track& track, double time) {
    const auto after = std::ranges::upper_bound(track.times, time);
    if (after == track.times.begin()) return key(track, 0);
    if (after == track.times.end()) return key(track, track.times.size() - 1);
    const auto next = static_cast<std::size_t>(after - track.times.begin());
    const std::size_t previous = next - 1;
    const Value from = key(track, previous), to = key(track, next);
    if (track.interpolation == "STEP") return from;

    const double span = track.times[next] - track.times[previous];
    const double t = (time - track.times[previous]) / span;
    if (track.interpolation == "CUBICSPLINE") {
        const Value out = key(track, previous, 2), in = key(track, next, 0);
        const double t2 = t * t, t3 = t2 * t;
        Value value{};
        for (std::size_t c = 0; c < track.components; ++c)
            value[c] = (2.0 * t3 - 3.0 * t2 + 1.0) * from[c] + span * (t3 - 2.0 * t2 + t) * out[c] +
                       (3.0 * t2 - 2.0 * t3) * to[c] + span * (t3 - t2) * in[c];
        return value;
    }
    if (track.components == 4) {
        const glm::dquat q = glm::slerp(quaternion(from), quaternion(to), t);
        return {q.x, q.y, q.z, q.w};
    }
    Value value{};
    for (std::size_t c = 0; c < track.components; ++c) value[c] = from[c] + (to[c] - from[c]) * t;
    return value;
}

Result<Track> readTrack(const tinygltf::Model& model, const tinygltf::AnimationSampler& sampler, std::size_t components,
                        const std::string& place) {
    Track track;
    track.components = components;
    track.interpolation = sampler.interpolation;
    const bool cubic = sampler.interpolation == "CUBICSPLINE";
    if (!cubic && sampler.interpolation != "LINEAR" && sampler.interpolation != "STEP")
        return fail("{} has the interpolation \"{}\"; use LINEAR, STEP or CUBICSPLINE", place, sampler.interpolation);
    auto times = readNumbers(model, sampler.input, 1, place + ", key times");
    if (!times) return tl::unexpected(times.error());
    auto values = readNumbers(model, sampler.output, static_cast<int>(components), place + ", key values");
    if (!values) return tl::unexpected(values.error());
    track.times = std::move(*times);
    track.values = std::move(*values);
    if (track.values.size() != track.times.size() * components * (cubic ? 3 : 1))
        return fail("{} has {} keys but {} values; export the file again", place, track.times.size(),
                    track.values.size() / components);
    for (std::size_t i = 1; i < track.times.size(); ++i)
        if (!(track.times[i] > track.times[i - 1]))
            return fail("{} has key times that do not increase; export the file again", place);
    return track;
}

}  // namespace

Result<std::map<std::size_t, AnimatedNode>> sampleAnimations(const tinygltf::Model& model, double time) {
    std::map<std::size_t, AnimatedNode> nodes;
    for (std::size_t a = 0; a < model.animations.size(); ++a) {
        const tinygltf::Animation& animation = model.animations[a];
        for (const tinygltf::AnimationChannel& channel : animation.channels) {
            const std::string& path = channel.target_path;
            if (channel.target_node < 0 || path == "weights") continue;
            const std::string place = animation.name.empty() ? fmt::format("animation {}", a)
                                                             : fmt::format("animation \"{}\"", animation.name);
            if (path != "translation" && path != "rotation" && path != "scale")
                return fail("{} moves \"{}\" of a node, which has no meaning; export the file again", place, path);
            const auto track = readTrack(model, animation.samplers[static_cast<std::size_t>(channel.sampler)],
                                         path == "rotation" ? 4 : 3, place);
            if (!track) return tl::unexpected(track.error());
            const Value value = sample(*track, time);
            AnimatedNode& node = nodes[static_cast<std::size_t>(channel.target_node)];
            if (path == "translation") node.translation = glm::dvec3(value[0], value[1], value[2]);
            if (path == "rotation") node.rotation = quaternion(value);
            if (path == "scale") node.scale = glm::dvec3(value[0], value[1], value[2]);
        }
    }
    return nodes;
}

}  // namespace tyndall::app
