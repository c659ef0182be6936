// Files as words and text.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace permgen {

/// The bytes of a regular file; throws a Fault where it cannot be read.
std::string read_bytes(const std::filesystem::path& file);

/// The words of a .spv file, as permgen writes it: little-endian. Throws a Fault where it is no SPIR-V.
std::vector<std::uint32_t> read_spirv(const std::filesystem::path& file);

}  // namespace permgen
