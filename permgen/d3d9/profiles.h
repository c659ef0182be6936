// The shader profiles that a `compile` may name. permgen treats all profiles of a stage the same.
#pragma once

#include <span>
#include <string_view>

namespace permgen::d3d9 {

inline constexpr std::string_view vertex_profiles[] = {"vs_1_1", "vs_2_0", "vs_2_a", "vs_2_sw", "vs_3_0", "vs_3_sw",
                                                       // Direct3D 11's names for the same hardware.
                                                       "vs_4_0_level_9_1", "vs_4_0_level_9_3"};

inline constexpr std::string_view pixel_profiles[] = {"ps_1_1", "ps_1_2",  "ps_1_3",           "ps_1_4",
                                                      "ps_2_0", "ps_2_a",  "ps_2_b",           "ps_2_sw",
                                                      "ps_3_0", "ps_3_sw", "ps_4_0_level_9_1", "ps_4_0_level_9_3"};

}  // namespace permgen::d3d9
