// Render targets of frames, kept while their size stays the same.
#pragma once

#include <headless/image.h>
#include <kit/fail.h>
#include <tyndall/plan.h>

#include "view_options.h"

namespace tyndall::app {

constexpr VkFormat colourFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
constexpr VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;

struct FrameTargets {
    headless::Image colour;        ///< COLOR_ATTACHMENT_OPTIMAL once surfaces are drawn
    headless::Image depth;         ///< reversed, 0 without a surface; then DEPTH_READ_ONLY_OPTIMAL
    headless::Image accumulation;  ///< made for the first frame that shows a shaft
    bool storage = false;          ///< the accumulation image is a storage image, too
};

/// Makes colour and depth of that size, unless they exist.
Result<void> fit(const headless::Device& device, FrameTargets& targets, Size size);

/// Makes the accumulation target, as large as colour and depth, unless it exists. Where rays can be computed it is a
/// storage image.
Result<void> fitAccumulation(const headless::Device& device, FrameTargets& targets, const PlanOptions& options);

}  // namespace tyndall::app
