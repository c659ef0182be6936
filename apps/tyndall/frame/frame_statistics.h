// Statistics of one frame.
#pragma once

#include <tyndall/renderer.h>

#include <cstdint>

namespace tyndall::app {

/// Times in milliseconds from submission to fence, by the host's clock, of this frame only.
struct FrameStatistics {
    double pipelines = 0.0;  ///< making the shafts' pipelines
    double shadowMaps = 0.0, surfaces = 0.0, accumulate = 0.0, composite = 0.0;
    std::uint64_t fragments = 0;  ///< shaded while slices were added, rounded up by some drivers
    bool fragmentsKnown = false;  ///< false if the device cannot count
    RendererCounters shafts;
    std::uint64_t surfaceDraws = 0, surfacePipelines = 0;
    std::uint64_t imagesUploaded = 0, imageBytes = 0;  ///< textures, cookies and noise, of surfaces and shafts
    int rounds = 0;                    ///< above 1 if the shafts' exposure required smaller errors; times and draws
                                       ///< of slices are the last round's
    std::uint64_t deviceBytes = 0;     ///< maximum of the device memory until this frame's end
    std::uint64_t frameDataBytes = 0;  ///< the part for the slices' vertices, indices and constants
};

}  // namespace tyndall::app
