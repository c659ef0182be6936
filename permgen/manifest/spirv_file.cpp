#include "spirv_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "fault.h"

namespace permgen {
namespace {

constexpr std::uint32_t magic = 0x07230203;  // SPIR-V 1.6, 2.3 "Physical Layout"
constexpr std::size_t header_bytes = 20;     // five words, same place

[[noreturn]] void broken(const std::filesystem::path& file, const std::string& what,
                         ErrorCode code = ErrorCode::Format) {
    throw Fault{file.string() + ": " + what + "; write it again with permgen compile", code};
}

}  // namespace

std::string read_bytes(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) broken(file, "there is no such file", ErrorCode::File);
    if (!std::filesystem::is_regular_file(status)) broken(file, "this is not a regular file", ErrorCode::File);
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    if (stream.peek() != std::ifstream::traits_type::eof()) bytes << stream.rdbuf();
    if (!stream.is_open() || stream.bad() || bytes.fail())
        broken(file, std::string("the file cannot be read (") + std::strerror(errno) + ")", ErrorCode::File);
    return std::move(bytes).str();
}

std::vector<std::uint32_t> read_spirv(const std::filesystem::path& file) {
    const std::string bytes = read_bytes(file);
    if (bytes.size() < header_bytes)
        broken(file, "the file ends after " + std::to_string(bytes.size()) + " bytes, within SPIR-V's header");
    if (bytes.size() % 4 != 0)
        broken(file, "the file has " + std::to_string(bytes.size()) + " bytes, which is not a whole number of words");
    std::vector<std::uint32_t> words(bytes.size() / 4);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        words[i / 4] |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * (i % 4));
    if (words[0] != magic) broken(file, "the file does not begin with SPIR-V's magic number");
    return words;
}

}  // namespace permgen
