#include "surface_lights.h"

namespace tyndall::app {

std::vector<SurfaceLight> allLights(std::span<const Light> lights,
                                    std::span<const std::vector<std::size_t>> instances) {
    std::vector<SurfaceLight> all;
    for (std::size_t i = 0; i < lights.size(); ++i)
        all.push_back({true, lights[i].shadow && !instances[i].empty(), {}});
    return all;
}

}  // namespace tyndall::app
