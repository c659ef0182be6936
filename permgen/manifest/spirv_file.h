// Reads files as words and text.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace permgen {

/// The bytes of a regular file; throws a Fault if it cannot be read.
std::string read_bytes(const std::filesystem::path& file);

/// The words of a .spv file, little-endian as permgen writes it. Throws a Fault if it is not SPIR-V.
std::vector<std::uint32_t> read_spirv(const std::filesystem::path& file);

}  // namespace permgen
