// An effect's `sampler_state` tables as Vulkan samplers.
#pragma once

#include <permgen/tables.h>
#include <tyndall/result.h>
#include <vulkan/vulkan_core.h>

#include <span>

namespace tyndall {

/// `states` applied to Direct3D 9's defaults (point filtering, no mip levels, wrapping). The later of two settings of a
/// state wins. `Texture` is ignored: it names the texture that the caller binds.
/// Errors: InvalidArgument naming the unsupported state or value.
Result<VkSamplerCreateInfo> samplerInfo(std::span<const permgen::State> states);

}  // namespace tyndall
