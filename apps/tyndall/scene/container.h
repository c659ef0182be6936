// The container of a glTF file: the JSON text and, in a .glb, the binary chunk after it.
#pragma once

#include <kit/fail.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tyndall::app {

struct Container {
    std::vector<unsigned char> bytes;  ///< the whole file
    std::size_t jsonOffset = 0, jsonLength = 0;
    std::size_t binaryLength = 0;  ///< bytes of the binary chunk, 0 without one
    bool binary = false;           ///< a .glb

    std::string_view json() const { return {reinterpret_cast<const char*>(bytes.data()) + jsonOffset, jsonLength}; }
};

/// Reads the file and finds its chunks. GLB layout: glTF 2.0 specification, section 4.4.
Result<Container> readContainer(const std::string& path);

/// False if the JSON text nests deeper than any glTF needs; recursive readers would overflow the stack.
bool nestingIsSane(std::string_view json);

}  // namespace tyndall::app
