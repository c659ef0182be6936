// The one place where HLSL becomes SPIR-V. Everything that knows glslang's API is in compile.cpp, so that
// another front end can take its place.
#pragma once

#include <permgen/tables.h>

#include <cstdint>
#include <string>
#include <vector>

namespace permgen {

struct CompileResult {
    std::vector<std::uint32_t> code;  ///< empty: it failed, and the log says why
    std::string log;                  ///< the front end's own words; compile_log.h makes diagnostics of them
};

/// Compiles one entry point for Vulkan 1.1 and later. May crash or hang on malformed input: call it
/// inside a worker (worker.h).
CompileResult compile_hlsl(Stage stage, const std::string& entry, const std::string& hlsl);

/// Does what the first compilation in a process has to do once (about 25 ms), so that workers forked
/// afterwards start warm.
void warm_up_compiler();

}  // namespace permgen
