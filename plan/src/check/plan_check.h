// The bounds that plan() documents, checked. Every message names the place, the field, its value, the
// rule it breaks and what to do about it.
#pragma once

#include <tyndall/light.h>
#include <tyndall/plan.h>
#include <tyndall/result.h>
#include <tyndall/view.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace tyndall {

Result<void> checkOptions(const PlanOptions& options);
Result<void> checkView(const View& view);
Result<void> checkSurroundings(const Surroundings& surroundings, std::size_t lights);
Result<void> checkLight(const Light& light, std::size_t index, const PlanOptions& options);

/// How messages name a light: its index among those given, and its name if it has one.
std::string placeOf(const Light& light, std::size_t index);

/// The shortest text with up to nine significant digits.
std::string text(double number);
/// As "(x, y, z)".
std::string text(const glm::dvec3& v);

bool isFinite(const glm::dvec3& v);

tl::unexpected<Error> broken(const std::string& sentence);

/// The error with Error::place.
tl::unexpected<Error> at(std::string place, Error error);

/// What a message is about. Its text is made only for a message: a thousand lights are checked in every frame.
struct CheckedObject {
    std::string_view name;         ///< of anything but a light
    const Light* light = nullptr;  ///< with its number
    std::size_t index = 0;
    std::string text() const { return light ? placeOf(*light, index) : std::string(name); }
};

/// A field with a closed range.
struct Bound {
    std::string_view field;
    double value;
    double min, max;
    std::string_view rule;    ///< completes "it must be ..."
    std::string_view remedy;  ///< an imperative
};

Result<void> checkBounds(const CheckedObject& place, std::span<const Bound> bounds);

/// A pose has no scale, shear or mirroring, and its translation stays within the range that a double resolves to a
/// micrometre.
Result<void> checkRigid(const CheckedObject& place, std::string_view field, const glm::dmat4& pose);

/// Largest coordinate, in metres, that doubles resolve well below a micrometre.
inline constexpr double farthest = 1e9;

/// Maximum difference between the columns' dot products and those of a rotation. Matrices that were floats once, or
/// quaternions in floats, are off by a few 1e-7.
inline constexpr double rigidTolerance = 1e-6;

}  // namespace tyndall
