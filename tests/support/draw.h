// Draws a shot with the runtime, like a program.
#pragma once

#include <tyndall/plan.h>
#include <tyndall/renderer.h>

#include <functional>
#include <optional>
#include <string_view>

#include "gpu.h"
#include "oracle.h"
#include "picture.h"

namespace tyndall::test {

struct DrawOptions {
    Method method = Method::Slices;
    bool storage = false;  ///< ShaftTargets::storage
    Geometry geometry = Geometry::ExactPolygons;
    Accumulation accumulation = Accumulation::Rgba32f;
    double range = 1.0;                         ///< PlanOptions::range
    std::optional<TermSet> terms;               ///< PlanOptions::terms
    std::optional<std::string_view> drawnWith;  ///< replaces the planned technique: any of the effect's
    Shaders shaders = Shaders::Frozen;          ///< DeviceContext::shaders
    bool composite = false;                     ///< into a picture of kBackground
    bool blur = false;                          ///< when compositing
    std::function<void(Plan&)> change;          ///< of the plan, before it is drawn
};

inline constexpr std::array<float, 4> kBackground{0.125f, 0.25f, 0.5f, 1.0f};

struct Drawing {
    Plan plan;
    Picture sum;                ///< the accumulation target, as stored
    Picture picture;            ///< the picture after compositing
    RendererCounters counters;  ///< of this drawing alone; pipelines may have been made before
};

/// The difference of two counters.
RendererCounters difference(const RendererCounters& after, const RendererCounters& before);

View viewOf(const Shot& shot);
PlanOptions planOptionsOf(const Shot& shot, const DrawOptions& options);

/// An image for the shadow hierarchy of a map with that many texels a side.
headless::Image shadowHierarchyImage(std::uint32_t mapSize);

/// Its levels, for recordShadowHierarchy(). `image` and `whole`, which becomes its view, must outlive the result.
ShadowHierarchy levelsOf(const headless::Image& image, const VkImageView& whole);

/// Plans, uploads only what the technique needs, accumulates, reads back.
Drawing draw(const Shot& shot, const DrawOptions& options = {});

}  // namespace tyndall::test
