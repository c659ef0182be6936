// The one place where HLSL becomes SPIR-V. Only compile.cpp uses glslang's API, so that another front end can replace
// it.
#pragma once

#include <permgen/tables.h>

#include <cstdint>
#include <string>
#include <vector>

namespace permgen {

struct CompileResult {
    std::vector<std::uint32_t> code;  ///< empty: it failed; the log gives the reason
    std::string log;                  ///< the front end's own text; compile_log.h turns it into diagnostics
};

/// Compiles one entry point for Vulkan 1.1 and later. May crash or hang on malformed input: call it
/// inside a worker (worker.h).
CompileResult compile_hlsl(Stage stage, const std::string& entry, const std::string& hlsl);

/// Does the initialization of a process's first compilation (about 25 ms), so that workers forked afterwards start
/// faster.
void warm_up_compiler();

}  // namespace permgen
