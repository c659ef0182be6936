// The exception of the loader's parts. load_manifest() catches it, so it stays within this library.
#pragma once

#include <permgen/error.h>

namespace permgen {

struct Fault {
    std::string message;  ///< the message of load_manifest()'s Error
    ErrorCode code = ErrorCode::Format;
};

}  // namespace permgen
