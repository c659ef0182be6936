// The types of an effect's constants. The tables have a member's offset; only the SPIR-V has its type.
#pragma once

#include <permgen/tables.h>
#include <tyndall/result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tyndall::rig {

/// One member of a uniform block: `elements` matrices or vectors of `rows` rows of `columns` numbers, as in
/// HLSL: mul(matrix, vector) multiplies a row with the vector. A vector or a single number is one row.
struct BlockMember {
    std::string name;
    const permgen::Resource* block = nullptr;
    permgen::ScalarType type = permgen::ScalarType::Float;
    std::uint32_t offset = 0, size = 0;  ///< bytes
    std::uint32_t elements = 1, rows = 1, columns = 1;
    bool array = false, settable = true;  ///< structures and arrays of arrays are not settable
    std::uint32_t elementStride = 0;      ///< bytes
    std::uint32_t rowStride = 0, columnStride = 4;

    std::size_t count() const { return std::size_t(elements) * rows * columns; }
    std::string typeName() const;  ///< "float4", "float4x4", "float4[8]"
};

/// Every member of every block, in the tables' order. Errors: a module whose blocks differ from the tables.
Result<std::vector<BlockMember>> blockMembers(const permgen::Effect& effect);

}  // namespace tyndall::rig
