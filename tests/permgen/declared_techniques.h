// The techniques that slices.fx declares, read from its text: an oracle that shares nothing with permgen's parser.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace permgen {

struct DeclaredTechnique {
    std::string name;
    std::vector<std::pair<std::string, bool>> switches;  ///< of ps_main, in its order: {"bCookie", true}
};

/// `path`: slices.fx. Its techniques are the lines SLICE_TECHNIQUE(name, true, ...); each `uniform bool` parameter of
/// the file belongs to ps_main.
std::vector<DeclaredTechnique> declared_techniques(const std::string& path);

}  // namespace permgen
