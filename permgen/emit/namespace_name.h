// Names for the generated header's namespace.
#pragma once

#include <string>
#include <string_view>

namespace permgen {

/// Whether C++ reserves the word, or the generated header needs it (`std`, `permgen`).
bool is_keyword(std::string_view word);

/// Whether "studio::slices" can be a namespace: identifiers other than C++ keywords and reserved names.
bool is_namespace(const std::string& name);

/// A namespace for an effect of that name: "3d noise" becomes "effect_3d_noise".
std::string default_namespace(const std::string& effect);

}  // namespace permgen
