// How the loader's parts give up: caught in load_manifest(), never seen outside of this library.
#pragma once

#include <permgen/error.h>

namespace permgen {

struct Fault {
    std::string message;  ///< the sentence that load_manifest() answers with
    ErrorCode code = ErrorCode::Format;
};

}  // namespace permgen
