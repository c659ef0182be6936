// Direct3D 11's types of resources that a shader reads and writes at any place: storage images and storage buffers.
#pragma once

#include <permgen/tables.h>

#include <string_view>

namespace permgen::d3d9 {

struct StorageType {
    std::string_view word;  ///< "RWTexture2D"
    ResourceKind kind;
    ImageDimension dimension;
    bool writable;
    bool has_element;  ///< followed by <TYPE>
};

inline constexpr StorageType storage_types[] = {
    {"RWTexture1D", ResourceKind::StorageImage, ImageDimension::One, true, true},
    {"RWTexture2D", ResourceKind::StorageImage, ImageDimension::Two, true, true},
    {"RWTexture3D", ResourceKind::StorageImage, ImageDimension::Three, true, true},
    {"StructuredBuffer", ResourceKind::StorageBuffer, ImageDimension::None, false, true},
    {"RWStructuredBuffer", ResourceKind::StorageBuffer, ImageDimension::None, true, true},
    {"ByteAddressBuffer", ResourceKind::StorageBuffer, ImageDimension::None, false, false},
    {"RWByteAddressBuffer", ResourceKind::StorageBuffer, ImageDimension::None, true, false}};

/// The type of that name, or nullptr.
constexpr const StorageType* find_storage_type(std::string_view word) {
    for (const StorageType& type : storage_types)
        if (type.word == word) return &type;
    return nullptr;
}

}  // namespace permgen::d3d9
