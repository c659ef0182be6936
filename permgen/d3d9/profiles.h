// The shader profiles that a `compile` may name: Direct3D 9's, and Direct3D 10's and 11's for compute shaders. permgen
// treats all profiles of vertex and pixel shaders the same; a compute profile limits the thread group.
#pragma once

#include <permgen/tables.h>

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "d3d9/states.h"

namespace permgen::d3d9 {

inline constexpr std::string_view vertex_profiles[] = {"vs_1_1", "vs_2_0", "vs_2_a", "vs_2_sw", "vs_3_0", "vs_3_sw",
                                                       // Direct3D 11's names for the same hardware.
                                                       "vs_4_0_level_9_1", "vs_4_0_level_9_3"};

inline constexpr std::string_view pixel_profiles[] = {"ps_1_1", "ps_1_2",  "ps_1_3",           "ps_1_4",
                                                      "ps_2_0", "ps_2_a",  "ps_2_b",           "ps_2_sw",
                                                      "ps_3_0", "ps_3_sw", "ps_4_0_level_9_1", "ps_4_0_level_9_3"};

// Direct3D 9 has no compute shaders.
inline constexpr std::string_view compute_profiles[] = {"cs_4_0", "cs_4_1", "cs_5_0", "cs_5_1"};

/// The words of a stage in an effect.
struct StageWords {
    Stage stage;
    std::string_view state;   ///< of a pass: "PixelShader"
    std::string_view prefix;  ///< of its profiles: "ps_"
    std::string_view usual;   ///< the profile to suggest
    std::span<const std::string_view> profiles;
};

inline constexpr StageWords stages[] = {{Stage::Vertex, "VertexShader", "vs_", "vs_3_0", vertex_profiles},
                                        {Stage::Pixel, "PixelShader", "ps_", "ps_3_0", pixel_profiles},
                                        {Stage::Compute, "ComputeShader", "cs_", "cs_5_0", compute_profiles}};

/// The most threads of a group: along each axis, and in all (Direct3D 11, "numthreads").
struct GroupLimits {
    std::string_view profiles;  ///< "cs_5_0"
    std::array<std::uint32_t, 3> size;
    std::uint32_t threads;
};

constexpr GroupLimits group_limits(std::string_view profile) {
    if (same_word(profile.substr(0, 4), "cs_4")) return {"cs_4", {768, 768, 1}, 768};
    return {"cs_5", {1024, 1024, 64}, 1024};
}

}  // namespace permgen::d3d9
