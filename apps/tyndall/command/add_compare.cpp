#include <kit/image/write_picture.h>

#include <cmath>

#include "add_options.h"

namespace tyndall::app {

void addCompare(CLI::App& app, CompareOptions& options) {
    app.add_option("image", options.image, "picture to compare, OpenEXR or PNG")->required()->type_name("IMAGE");
    app.add_option("reference", options.reference, "correct picture, of the same size and channels")
        ->required()
        ->type_name("REFERENCE");
    app.add_flag("--json", options.json, "as JSON");
    addOptional(app, "--difference", options.difference, "OUT",
                "picture of image - reference to write: .exr signed, .png blue (darker) over white to red (brighter)");
    addOptional(app, "--difference-scale", options.differenceScale, "D",
                "difference that a .png shows in full colour; the largest");
    app.add_option("--banding-threshold", options.bandingThreshold,
                   "smallest relative change of the reference over equal values that counts as a band; 0.001")
        ->type_name("T");
    Limits& limits = options.limits;
    addOptional(app, "--max-relative-l2", limits.relativeL2, "E", "fail above this relative L2 error");
    addOptional(app, "--max-relative-mean-square", limits.relativeMeanSquare, "E",
                "fail above this relative mean square error");
    addOptional(app, "--max-absolute", limits.absolute, "E", "fail if any value is off by more");
    addOptional(app, "--max-energy", limits.energy, "E", "fail if the mean is off by more than this share of it");
    addOptional(app, "--max-run", limits.run, "N", "fail if a band is longer than this many pixels");
    addOptional(app, "--max-dead-zone", limits.deadZone, "R", "fail if the image is 0 at a reference value above this");
}

Result<void> checkCompare(const CompareOptions& options) {
    if (options.difference && !pictureFormat(*options.difference))
        return fail("--difference: {} is neither .png nor .exr; give the picture one of these extensions",
                    *options.difference);
    const auto check = [](const char* name, std::optional<double> value) -> Result<void> {
        if (!value || (*value >= 0.0 && std::isfinite(*value))) return {};
        return fail("{}: must be a number from 0", name);
    };
    const Limits& limits = options.limits;
    for (const auto& [name, value] :
         {std::pair("--max-relative-l2", limits.relativeL2),
          std::pair("--max-relative-mean-square", limits.relativeMeanSquare),
          std::pair("--max-absolute", limits.absolute), std::pair("--max-energy", limits.energy),
          std::pair("--max-dead-zone", limits.deadZone),
          std::pair("--banding-threshold", std::optional(options.bandingThreshold))})
        if (auto checked = check(name, value); !checked) return checked;
    if (limits.run && *limits.run < 0) return fail("--max-run: must be a number of pixels from 0");
    if (!options.differenceScale) return {};
    if (!(*options.differenceScale > 0.0 && std::isfinite(*options.differenceScale)))
        return fail("--difference-scale: must be above 0");
    if (!options.difference || pictureFormat(*options.difference) != PictureFormat::Png)
        return fail("--difference-scale: only a .png has a scale; add --difference OUT.png");
    return {};
}

}  // namespace tyndall::app
