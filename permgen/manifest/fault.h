// How the loader's parts give up: caught in load_manifest(), never seen outside of this library.
#pragma once

#include <string>

namespace permgen {

struct Fault {
    std::string message;  ///< the sentence that load_manifest() answers with
};

}  // namespace permgen
