#include <kit/image/difference.h>
#include <kit/image/files.h>
#include <kit/image/write_picture.h>

#include <algorithm>
#include <cmath>

#include "commands.h"
#include "compare_report.h"
#include "json_text.h"

namespace tyndall::app {
namespace {

Result<void> checkDifference(const std::string& path, const CompareOptions& options) {
    for (const std::string& input : {options.image, options.reference})
        if (sameFile(path, input)) return fail("--difference: {} is {} itself; name another file", path, input);
    return checkWritable(path);
}

/// Returns a sentence about the picture.
Result<std::string> writeDifference(const std::string& path, const Comparison& comparison,
                                    const CompareOptions& options) {
    const Image signedDifference = difference(comparison.image.image, comparison.reference.image);
    if (pictureFormat(path) == PictureFormat::Exr) {
        if (auto done = writeExr(path, signedDifference, comparison.image.channels); !done)
            return tl::unexpected(done.error());
        return fmt::format("wrote {}: image - reference", path);
    }
    const double largest = comparison.metrics.maximumAbsolute;
    const double scale = options.differenceScale.value_or(largest > 0.0 ? largest : 1.0);
    const auto colours = divergingColours(signedDifference, scale);
    if (auto done = writePng(path, signedDifference.width, signedDifference.height, colours); !done)
        return tl::unexpected(done.error());
    return fmt::format("wrote {}: from blue, darker by {:g}, over white to red, brighter by {:g}", path, scale, scale);
}

}  // namespace

Result<CommandOutput> compare(const CompareOptions& options) {
    if (options.difference)
        if (auto checked = checkDifference(*options.difference, options); !checked)
            return tl::unexpected(checked.error());
    Comparison comparison;
    auto image = readPicture(options.image);
    if (!image) return tl::unexpected(image.error());
    auto reference = readPicture(options.reference);
    if (!reference) return tl::unexpected(reference.error());
    comparison.image = std::move(*image);
    comparison.reference = std::move(*reference);
    auto metrics = study::compare(comparison.image.image, comparison.reference.image,
                                  {.bandingThreshold = options.bandingThreshold});
    if (!metrics)
        return passOn(metrics.error(), fmt::format("{} cannot be compared with {}", options.image, options.reference));
    comparison.metrics = *metrics;
    if (comparison.image.channels != comparison.reference.channels)
        return fail(
            "{} cannot be compared with {}: the channels are {} in the image and {} in the reference; rename them",
            options.image, options.reference, fmt::join(comparison.image.channels, " "),
            fmt::join(comparison.reference.channels, " "));

    CommandOutput result;
    if (options.difference) {
        auto written = writeDifference(*options.difference, comparison, options);
        if (!written) return tl::unexpected(written.error());
        result.notes.push_back(std::move(*written));
    }
    result.output = options.json ? jsonText(compareReport(comparison, options)) : compareText(comparison, options);
    result.verdict = verdict(comparison, options);
    return result;
}

}  // namespace tyndall::app
