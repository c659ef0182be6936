#include <study/metrics.h>

#include <cmath>
#include <limits>

#include "exact_sum.h"

namespace tyndall::study {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double darkShare = 0.01;

PixelIndex placeOf(const Image& image, std::size_t index) {
    const std::size_t pixel = index / image.channels;
    return {static_cast<int>(pixel % image.width), static_cast<int>(pixel / image.width),
            static_cast<int>(index % image.channels)};
}

tl::unexpected<Error> broken(std::string sentence) {
    return tl::unexpected(Error{ErrorCode::InvalidArgument, std::move(sentence)});
}

Result<void> check(const Image& image, const char* what) {
    const auto problem = [what](const std::string& text) { return broken(std::string(what) + " " + text); };
    if (image.width < 1 || image.height < 1 || image.channels < 1) return problem("has no pixels");
    const std::size_t values = static_cast<std::size_t>(image.width) * image.height * image.channels;
    if (image.values.size() != values)
        return problem("holds " + std::to_string(image.values.size()) + " values, but its size says " +
                       std::to_string(values));
    return {};
}

Result<void> checkAlike(const Image& image, const Image& reference) {
    if (auto checked = check(image, "the image"); !checked) return checked;
    if (auto checked = check(reference, "the reference"); !checked) return checked;
    const auto size = [](const Image& of) { return std::to_string(of.width) + "x" + std::to_string(of.height); };
    if (image.width != reference.width || image.height != reference.height)
        return broken("the image is " + size(image) + " pixels and the reference " + size(reference) +
                      "; make them in one size");
    if (image.channels != reference.channels)
        return broken("the image has " + std::to_string(image.channels) + " channels and the reference " +
                      std::to_string(reference.channels) + "; write both with the same ones");
    return {};
}

template <class Visit>
void forEachFinitePair(const Image& image, const Image& reference, Visit&& visit) {
    for (std::size_t k = 0; k < image.values.size(); ++k)
        if (std::isfinite(image.values[k]) && std::isfinite(reference.values[k]))
            visit(k, static_cast<double>(image.values[k]), static_cast<double>(reference.values[k]));
}

/// Of two sums; 0 / 0 is 0: nothing is wrong with nothing.
double ratio(double part, double whole) {
    if (whole != 0.0) return part / whole;
    return part == 0.0 ? 0.0 : std::copysign(infinity, part);
}

double relativeMeanSquare(const Image& image, const Image& reference, double dark, std::uint64_t compared) {
    ExactSum sum;
    forEachFinitePair(image, reference,
                      [&](std::size_t, double i, double r) { sum.add((i - r) * (i - r) / (r * r + dark * dark)); });
    return sum.value() / static_cast<double>(compared);
}

}  // namespace

NonFinite countNonFinite(const Image& image) {
    NonFinite found;
    for (std::size_t k = 0; k < image.values.size(); ++k) {
        const float value = image.values[k];
        if (std::isfinite(value)) continue;
        ++(std::isnan(value) ? found.nan : found.infinite);
        if (!found.first) found.first = placeOf(image, k);
    }
    return found;
}

Result<Metrics> compare(const Image& image, const Image& reference, const MetricOptions& options) {
    if (auto checked = checkAlike(image, reference); !checked) return tl::unexpected(checked.error());
    Metrics metrics;
    metrics.width = image.width;
    metrics.height = image.height;
    metrics.channels = image.channels;
    metrics.image = countNonFinite(image);
    metrics.reference = countNonFinite(reference);

    ExactSum difference, squaredDifference, light, squaredLight;
    forEachFinitePair(image, reference, [&](std::size_t k, double i, double r) {
        const double error = i - r;
        difference.add(error);
        squaredDifference.add(error * error);
        light.add(r);
        squaredLight.add(r * r);
        if (metrics.compared++ == 0 || std::abs(error) > metrics.maximumAbsolute) {
            metrics.maximumAbsolute = std::abs(error);
            metrics.worst = {placeOf(image, k), i, r};
        }
        if (i == 0.0 && r != 0.0) {
            if (metrics.deadZone.count++ == 0 || std::abs(r) > std::abs(metrics.deadZone.largest.reference))
                metrics.deadZone.largest = {placeOf(image, k), i, r};
        }
    });
    if (metrics.compared == 0) return metrics;

    const auto count = static_cast<double>(metrics.compared);
    const double squaredError = squaredDifference.value();
    metrics.relativeL2 = std::sqrt(ratio(squaredError, squaredLight.value()));
    metrics.dark = darkShare * std::sqrt(squaredLight.value() / count);
    metrics.relativeMeanSquare = metrics.dark > 0.0
                                     ? relativeMeanSquare(image, reference, metrics.dark, metrics.compared)
                                     : ratio(squaredError, 0.0);
    metrics.meanDifference = difference.value() / count;
    metrics.energy = ratio(metrics.meanDifference, light.value() / count);
    metrics.deadZone.share = static_cast<double>(metrics.deadZone.count) / count;
    metrics.banding = findBanding(image, reference, options.bandingThreshold, metrics.dark);
    return metrics;
}

}  // namespace tyndall::study
