// Numbers from glTF accessors, converted from their stored type.
#pragma once

#include <cstdint>
#include <vector>

#include "document.h"

namespace tyndall::app {

/// All elements of an accessor of a checked document, `components` doubles each, normalized integers
/// scaled as in glTF 2.0, section 3.6.2.2. `what` names the use in errors, e.g. "mesh \"Floor\", POSITION".
/// Errors: another number of components; a value that is not finite.
Result<std::vector<double>> readNumbers(const tinygltf::Model& model, int accessor, int components,
                                        const std::string& what);

/// The indices of a primitive. Errors: floats; an index of `vertexCount` or more.
Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int accessor, std::size_t vertexCount,
                                               const std::string& what);

}  // namespace tyndall::app
