// JSON helpers for the manifest and `permgen list --json`.
#pragma once

#include <permgen/tables.h>

#include <cstdint>
#include <nlohmann/json.hpp>

namespace permgen {

/// true, 3 or 0.5, depending on the type.
nlohmann::ordered_json constant_json(ScalarType type, std::uint32_t bits);

}  // namespace permgen
