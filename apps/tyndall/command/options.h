// The program's options, after parsing.
#pragma once

#include <kit/fail.h>
#include <study/reference.h>

#include <cstdint>
#include <optional>
#include <string>

#include "../frame/shaft_options.h"
#include "../frame/view_options.h"

namespace tyndall::app {

/// The number of slices as given; checkShafts() writes it into PlanOptions.
struct SliceCount {
    std::optional<int> planes;     ///< this many equal slabs a light; absent: as many as needed
    std::optional<int> maxSlices;  ///< at most this many; absent: defaultMaxSlices
};

struct RenderOptions {
    ViewOptions view;
    ShaftOptions shafts;
    SliceCount slices;
    std::string output;
    std::optional<std::string> stats;
    std::optional<std::string> pipelineCache;  ///< a file, or noPipelineCache; absent: the user's cache folder
    bool validate = false;
};

struct ExplainOptions {
    ViewOptions view;
    ShaftOptions shafts;
    SliceCount slices;
    bool json = false;
};

struct ReferenceOptions {
    ViewOptions view;  ///< its layer is ignored: a reference has the shafts only
    std::string output;
    study::Mode mode = study::Mode::Ideal;
    std::optional<TermSet> terms;  ///< absent: each light's own
    double accuracy = 1e-8;
    unsigned threads = 0;
    std::uint32_t shadowSize = 1024;  ///< hardware mode
    std::optional<std::string> stats;
};

/// Limits of a comparison; absent: no limit.
struct Limits {
    std::optional<double> relativeL2, relativeMeanSquare, absolute, energy, deadZone;
    std::optional<int> run;
};

struct CompareOptions {
    std::string image, reference;
    bool json = false;
    std::optional<std::string> difference;
    std::optional<double> differenceScale;  ///< absent: the largest difference
    double bandingThreshold = 1e-3;
    Limits limits;
};

/// "640x360". Errors: anything else, a side of 0 or over longestSide.
Result<Size> parseSize(const std::string& text);

/// The terms of a technique of slices.fx. Errors: another name; the message lists all.
Result<TermSet> parseTechnique(const std::string& name);

}  // namespace tyndall::app
