// The ways to a light's shafts. All of them give the same integral; they differ in cost and in what is left of error.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tyndall {

enum class Method : std::uint8_t {
    Slices,   ///< the published one (slices.fx): planes across the view, each weighted with its slab
    Raycast,  ///< one ray for each pixel (raycast.fxh). It follows the texels of cookie, noise and shadow map and is
              ///< exact to the texel, as long as the ray crosses less than about 16 000 borders between them: above
              ///< that it samples them. The cost grows with the texels that a ray crosses, up to that number. A
              ///< routed target keeps one grey value as for slices, but gains no digits
};

inline constexpr std::array allMethods{Method::Slices, Method::Raycast};

/// "slices": as options and sentences name it.
constexpr std::string_view nameOf(Method method) {
    switch (method) {
        case Method::Slices:
            return "slices";
        case Method::Raycast:
            return "raycast";
    }
    return {};
}

}  // namespace tyndall
