// The texels behind an effect's samplers.
#pragma once

#include <permgen/tables.h>
#include <rig/image.h>

#include <map>
#include <string>

#include "fixture.h"

namespace tyndall::rig {

/// Four channels each, by the sampler's name. A generated texture is the same on every machine.
using Texels = std::map<std::string, Image>;

/// Errors: a sampler that the effect does not have (with the nearest name), a sampler that a technique reads and that
/// has no texture or is not 2D, an image file that cannot be read.
Result<Texels> makeTextures(const permgen::Effect& effect, const Fixture& fixture);

/// The same size, with every texel and channel changed: a picture that reads it must change.
Image altered(const Image& texels);

}  // namespace tyndall::rig
