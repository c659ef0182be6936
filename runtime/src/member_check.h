// Compile-time comparison of a C++ struct with a uniform block as permgen reflected it.
#pragma once

#include <permgen/tables.h>

#include <cstddef>

namespace tyndall {

/// True where the effect has that member there, of that size in bytes.
constexpr bool memberIs(const permgen::Effect& effect, std::string_view name, std::size_t offset, std::size_t size) {
    const permgen::Member* member = permgen::find_member(effect, name);
    return member && member->offset == offset && member->size == size;
}

/// True where every uniform block of the effect (there is one) has that size in bytes.
constexpr bool blockIs(const permgen::Effect& effect, std::size_t size) {
    std::size_t blocks = 0;
    for (const permgen::Resource& resource : effect.resources)
        if (resource.kind == permgen::ResourceKind::UniformBuffer) {
            ++blocks;
            if (resource.size != size) return false;
        }
    return blocks == 1;
}

}  // namespace tyndall
