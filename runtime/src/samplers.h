// An effect's `sampler_state` tables as Vulkan samplers.
#pragma once

#include <permgen/tables.h>
#include <tyndall/result.h>
#include <vulkan/vulkan_core.h>

#include <span>

namespace tyndall {

/// What `states` amount to, on top of Direct3D 9's defaults (point filtering, no mip levels, wrapping).
/// Of two settings of a state the later counts. `Texture` names what the
/// caller binds and says nothing about the sampler.
/// Errors: InvalidArgument naming the state, or the value, that has no meaning here.
Result<VkSamplerCreateInfo> samplerInfo(std::span<const permgen::State> states);

}  // namespace tyndall
