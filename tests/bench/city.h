// A city at night, for measurements: a lamp every 16 m on a square grid, the eye in a street in its middle.
#pragma once

#include <tyndall/plan.h>

#include <cmath>
#include <vector>

namespace tyndall::bench {

struct City {
    std::vector<Light> lights;
    OccluderSet houses;
    BlockerSet ground;
    std::vector<float> depth;
    View view;
    PlanOptions options;

    Surroundings surroundings() const {
        return {.occluders = &houses, .blockers = &ground, .depth = DepthTiles{16, 9, depth}, .surveys = {}};
    }
};

/// Lamps 6 m up, shining down at 70 degrees; a house in every fourth block. From the street, houses hide everything
/// beyond 150 m. A frame of 1920 x 1080, with all planning options on.
inline City city(std::size_t lamps) {
    City city;
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(lamps))));
    constexpr double pitch = 16.0;
    const double middle = 0.5 * pitch * static_cast<double>(side);
    std::vector<OccluderBox> boxes;
    const glm::dmat4 down(glm::dvec4(1, 0, 0, 0), {0, 0, -1, 0}, {0, 1, 0, 0}, {0, 0, 0, 1});
    for (std::size_t i = 0; i < lamps; ++i) {
        Light lamp;
        const double x = pitch * static_cast<double>(i % side) - middle,
                     z = pitch * static_cast<double>(i / side) - middle;
        lamp.worldFromLight = down;
        lamp.worldFromLight[3] = {x + 4.0, 6.0, z + 4.0, 1.0};
        lamp.fov = glm::dvec2(1.2);
        lamp.nearPlane = 0.2;
        lamp.farPlane = 6.2;
        lamp.intensity = 200.0;
        city.lights.push_back(lamp);
        if (i % 4 == 0) boxes.push_back({glm::dmat4(1.0), {x + 9.0, 0.0, z + 9.0}, {x + 15.0, 12.0, z + 15.0}, {}});
    }
    const double edge = middle + 20.0;
    const Blocker ground{{{{{-edge, 0, -edge}, {edge, 0, -edge}, {edge, 0, edge}}},
                          {{{-edge, 0, -edge}, {edge, 0, edge}, {-edge, 0, edge}}}}};
    boxes.push_back({glm::dmat4(1.0), {-edge, 0.0, -edge}, {edge, 0.0, edge}, {}});
    city.houses = OccluderSet::fromBoxes(boxes).value();
    city.ground = BlockerSet::fromBlockers({ground}).value();
    city.depth.assign(16 * 9, 150.0f);
    glm::dmat4 eye(1.0);
    eye[3] = {0.0, 1.7, 0.0, 1.0};
    city.view = perspectiveView(eye, 1.0, 16.0 / 9.0, 0.1, 1000.0);
    city.options.slices = 128;
    city.options.spacing = Spacing::Adaptive;
    city.options.pictureHeight = 1080;
    city.options.displayStep = 3e-4;
    return city;
}

}  // namespace tyndall::bench
