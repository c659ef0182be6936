// A lowered effect small enough to read: one vertex shader, one pixel shader with two switches, two
// techniques. It has the form of the front end's output.
#pragma once

#include "lower/lowered.h"

namespace permgen::test {

/// Techniques "plain" (both switches off) and "patterned" (bNoise off, bCookie on).
Lowered small_effect();

/// The pixel module's text with `body` as the author's function body; line 10 is its first line.
std::string pixel_text(const std::string& body);

}  // namespace permgen::test
