#include "compare_report.h"

#include <cmath>

namespace tyndall::app {
namespace {

using nlohmann::ordered_json;
using study::PixelIndex;

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : std::string(between)) + part;
    return text;
}

std::string pixelText(const Comparison& comparison, const PixelIndex& pixel) {
    return fmt::format("{} of pixel ({}, {})", comparison.image.channels[static_cast<std::size_t>(pixel.channel)],
                       pixel.x, pixel.y);
}

ordered_json pixelReport(const Comparison& comparison, const PixelIndex& pixel) {
    return {{"x", pixel.x},
            {"y", pixel.y},
            {"channel", comparison.image.channels[static_cast<std::size_t>(pixel.channel)]}};
}

ordered_json sampleReport(const Comparison& comparison, const study::Sample& sample) {
    ordered_json report = pixelReport(comparison, sample.place);
    report["image"] = sample.image;
    report["reference"] = sample.reference;
    return report;
}

ordered_json nonFiniteReport(const Comparison& comparison, const study::NonFinite& values) {
    ordered_json report{{"nan", values.nan}, {"infinite", values.infinite}};
    if (values.first) report["first"] = pixelReport(comparison, *values.first);
    return report;
}

std::string nonFiniteText(const Comparison& comparison, const char* whose, const study::NonFinite& values) {
    return fmt::format("{} holds {} NaN and {} infinite values, the first at {}", whose, values.nan, values.infinite,
                       pixelText(comparison, *values.first));
}

std::string worstText(const Comparison& comparison) {
    const study::Sample& worst = comparison.metrics.worst;
    return fmt::format("{}: {:g} instead of {:g}", pixelText(comparison, worst.place), worst.image, worst.reference);
}

std::string pictureLine(const char* role, const std::string& path, const ReadPicture& picture) {
    return fmt::format("{:<21} {}: {}x{}, {}, {}\n", role, path, picture.image.width, picture.image.height,
                       joined(picture.channels, " "), picture.encoding);
}

ordered_json pictureReport(const std::string& path, const ReadPicture& picture) {
    return {{"file", path}, {"encoding", picture.encoding}};
}

std::string bandText(const Comparison& comparison) {
    const study::Banding& band = comparison.metrics.banding;
    return fmt::format("{} equal pixels {} from {}, while the reference moves by {:.3g} ({:.3g} %)", band.longestRun,
                       band.alongRow ? "along the row" : "down the column", pixelText(comparison, band.start),
                       band.change, 100.0 * band.relativeChange);
}

std::string deadZoneText(const Comparison& comparison) {
    const study::DeadZone& dead = comparison.metrics.deadZone;
    return fmt::format("{} values ({:.3g} %) are 0 but not in the reference, which is up to {:.3g} at {}", dead.count,
                       100.0 * dead.share, std::abs(dead.largest.reference), pixelText(comparison, dead.largest.place));
}

ordered_json figuresReport(const Comparison& comparison, const CompareOptions& options) {
    const study::Metrics& metrics = comparison.metrics;
    ordered_json report;
    report["relativeL2"] = metrics.relativeL2;
    report["relativeMeanSquare"] = metrics.relativeMeanSquare;
    report["maximumAbsolute"] = metrics.maximumAbsolute;
    report["worst"] = sampleReport(comparison, metrics.worst);
    report["meanDifference"] = metrics.meanDifference;
    report["energy"] = metrics.energy;
    ordered_json& band =
        report["banding"] = {{"threshold", options.bandingThreshold}, {"longestRun", metrics.banding.longestRun}};
    if (metrics.banding.longestRun > 0) {
        band["along"] = metrics.banding.alongRow ? "row" : "column";
        band["start"] = pixelReport(comparison, metrics.banding.start);
        band["change"] = metrics.banding.change;
        band["relativeChange"] = metrics.banding.relativeChange;
    }
    ordered_json& dead = report["deadZone"] = {{"count", metrics.deadZone.count}, {"share", metrics.deadZone.share}};
    if (metrics.deadZone.count > 0) dead["largest"] = sampleReport(comparison, metrics.deadZone.largest);
    return report;
}

/// The members of figuresReport() for pictures that have no finite pair of values.
ordered_json noFigures(const CompareOptions& options) {
    return {{"relativeL2", nullptr},
            {"relativeMeanSquare", nullptr},
            {"maximumAbsolute", nullptr},
            {"worst", nullptr},
            {"meanDifference", nullptr},
            {"energy", nullptr},
            {"banding", {{"threshold", options.bandingThreshold}, {"longestRun", nullptr}}},
            {"deadZone", {{"count", nullptr}, {"share", nullptr}}}};
}

}  // namespace

ordered_json compareReport(const Comparison& comparison, const CompareOptions& options) {
    const study::Metrics& metrics = comparison.metrics;
    ordered_json report;
    report["image"] = pictureReport(options.image, comparison.image);
    report["reference"] = pictureReport(options.reference, comparison.reference);
    report["width"] = metrics.width;
    report["height"] = metrics.height;
    report["channels"] = comparison.image.channels;
    report["compared"] = metrics.compared;
    report["nonFinite"] = {{"image", nonFiniteReport(comparison, metrics.image)},
                           {"reference", nonFiniteReport(comparison, metrics.reference)}};
    report.update(metrics.compared > 0 ? figuresReport(comparison, options) : noFigures(options));
    const auto failed = verdict(comparison, options);
    report["passed"] = !failed;
    if (failed) report["verdict"] = *failed;
    return report;
}

std::string compareText(const Comparison& comparison, const CompareOptions& options) {
    const study::Metrics& metrics = comparison.metrics;
    std::string text = pictureLine("image", options.image, comparison.image) +
                       pictureLine("reference", options.reference, comparison.reference) + "\n";
    const auto line = [&text](const char* figure, const std::string& value) {
        text += fmt::format("{:<21} {}\n", figure, value);
    };
    if (metrics.image.count() > 0) line("not finite", nonFiniteText(comparison, "the image", metrics.image));
    if (metrics.reference.count() > 0)
        line("not finite", nonFiniteText(comparison, "the reference", metrics.reference));
    if (metrics.compared == 0) {
        line("figures", "nothing to compare: no value is finite in both pictures");
        return text;
    }
    line("relative L2", fmt::format("{:.4g}", metrics.relativeL2));
    line("relative mean square", fmt::format("{:.4g}", metrics.relativeMeanSquare));
    line("largest error", metrics.maximumAbsolute > 0.0
                              ? fmt::format("{:.4g}, {}", metrics.maximumAbsolute, worstText(comparison))
                              : "0");
    line("energy", fmt::format("{:+.4g} % (mean {:+.4g})", 100.0 * metrics.energy, metrics.meanDifference));
    line("banding", metrics.banding.longestRun > 0 ? bandText(comparison) : "none");
    line("dead zone", metrics.deadZone.count > 0 ? deadZoneText(comparison) : "none");
    return text;
}

std::optional<std::string> verdict(const Comparison& comparison, const CompareOptions& options) {
    const study::Metrics& metrics = comparison.metrics;
    const Limits& limits = options.limits;
    std::vector<std::string> faults;
    if (metrics.image.count() > 0) faults.push_back(nonFiniteText(comparison, "the image", metrics.image));
    if (metrics.reference.count() > 0) faults.push_back(nonFiniteText(comparison, "the reference", metrics.reference));
    bool ofThePicture = false;
    const auto hold = [&](const char* figure, double value, const char* option, std::optional<double> limit) {
        if (!limit || value <= *limit) return;
        faults.push_back(fmt::format("the {} is {:.4g}, above {} {:g}", figure, value, option, *limit));
        ofThePicture = true;
    };
    hold("relative L2", metrics.relativeL2, "--max-relative-l2", limits.relativeL2);
    hold("relative mean square", metrics.relativeMeanSquare, "--max-relative-mean-square", limits.relativeMeanSquare);
    hold("largest error", metrics.maximumAbsolute, "--max-absolute", limits.absolute);
    hold("share of energy gained or lost", std::abs(metrics.energy), "--max-energy", limits.energy);
    if (ofThePicture) faults.back() += fmt::format(" (worst is {})", worstText(comparison));
    if (limits.run && metrics.banding.longestRun > *limits.run)
        faults.push_back(fmt::format("{}, above --max-run {}", bandText(comparison), *limits.run));
    if (limits.deadZone && std::abs(metrics.deadZone.largest.reference) > *limits.deadZone)
        faults.push_back(fmt::format("{}, above --max-dead-zone {:g}", deadZoneText(comparison), *limits.deadZone));
    if (faults.empty()) return std::nullopt;
    return fmt::format("{}: {}", options.image, joined(faults, "; "));
}

}  // namespace tyndall::app
