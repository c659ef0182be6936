// A plan in words.
#pragma once

#include <tyndall/plan.h>

#include <string>
#include <vector>

namespace tyndall {

/// Why the light is drawn with these terms, or why it is not drawn: one sentence.
std::string reason(const PlannedLight& light, const View& view);

/// What was left out of a drawn light, and why: one sentence for each; empty if nothing was left out.
std::vector<std::string> savings(const PlannedLight& light);

/// Pixels that the part's slices cover in a picture of that size, one slice on top of the other: the fragments shaded
/// where nothing stands before them. For stretched quads, without the area that their clip distances cut off.
double expectedFragments(const Plan& plan, const PlannedPart& part, const View& view, std::uint32_t width,
                         std::uint32_t height);

}  // namespace tyndall
