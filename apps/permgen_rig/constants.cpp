#include "constants.h"

#include <common/nearest.h>
#include <fmt/format.h>
#include <kit/fail.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace tyndall::rig {
namespace {

void forEachNumber(const BlockMember& member, const std::function<void(std::size_t index, std::size_t offset)>& visit) {
    std::size_t index = 0;
    for (std::uint32_t element = 0; element < member.elements; ++element)
        for (std::uint32_t row = 0; row < member.rows; ++row)
            for (std::uint32_t column = 0; column < member.columns; ++column)
                visit(index++, member.offset + std::size_t(element) * member.elementStride + row * member.rowStride +
                                   column * member.columnStride);
}

bool representable(permgen::ScalarType type, double value) {
    if (type == permgen::ScalarType::Float) return std::abs(value) <= 3.4028234e38;
    const double minimum = type == permgen::ScalarType::Int ? -2147483648.0 : 0.0;
    const double maximum = type == permgen::ScalarType::Int ? 2147483647.0 : 4294967295.0;
    return value >= minimum && value <= maximum && value == std::floor(value);
}

std::uint32_t bitsOf(permgen::ScalarType type, double value) {
    std::uint32_t bits = 0;
    if (type == permgen::ScalarType::Float) {
        const float number = static_cast<float>(value);
        std::memcpy(&bits, &number, sizeof bits);
    } else {
        bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
    }
    return bits;
}

std::string numbers(std::size_t count) {
    return count == 1 ? "1 number" : fmt::format("{} numbers", count);
}

std::string whyNot(const BlockMember& member, const Numbers& given) {
    if (!member.settable) return "it is a structure or an array of arrays, which a fixture cannot fill";
    if (given.values.size() != member.count())
        return fmt::format("it is a {}: give {}, not {}", member.typeName(), numbers(member.count()),
                           given.values.size());
    // [[a, b], [c, d], [e, f]] for a float2x3 would be read in the wrong order without an error.
    if (given.shape.size() > 1 && given.shape.back() != member.columns)
        return fmt::format("it is a {}: the innermost lists have {}, not {}", member.typeName(),
                           numbers(member.columns), given.shape.back());
    for (const double value : given.values)
        if (!representable(member.type, value))
            return fmt::format("{} is not a value of a {}", value, member.typeName());
    return {};
}

}  // namespace

Result<Constants> fillConstants(const permgen::Effect& effect, const std::vector<BlockMember>& members,
                                const Fixture& fixture) {
    Constants constants;
    for (const permgen::Resource& resource : effect.resources)
        if (resource.kind == permgen::ResourceKind::UniformBuffer)
            constants.blocks[std::string(resource.name)].resize(resource.size);

    std::vector<std::string_view> names;
    for (const BlockMember& member : members) names.push_back(member.name);
    for (const auto& [name, given] : fixture.constants) {
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        const std::string known = names.empty() ? "it has none" : fmt::format("it has {}", fmt::join(names, ", "));
        return failWith(fmt::format("{}: constants.{}: {} has no such constant{}; {}", fixture.path, name, effect.name,
                                    permgen::suggestion(name, names, "; did you mean ", "?"), known));
    }
    for (const BlockMember& member : members) {
        const auto given = fixture.constants.find(member.name);
        if (given == fixture.constants.end()) {
            constants.unset.push_back(member.name);
            continue;
        }
        if (const std::string why = whyNot(member, given->second); !why.empty())
            return failWith(fmt::format("{}: constants.{}: {}", fixture.path, member.name, why));
        std::vector<std::byte>& bytes = constants.blocks.at(std::string(member.block->name));
        forEachNumber(member, [&](std::size_t index, std::size_t offset) {
            const std::uint32_t bits = bitsOf(member.type, given->second.values[index]);
            std::memcpy(&bytes.at(offset), &bits, sizeof bits);
        });
    }
    return constants;
}

std::vector<std::byte> altered(const std::vector<BlockMember>& members, std::string_view block,
                               std::vector<std::byte> bytes) {
    for (const BlockMember& member : members) {
        if (!member.settable || member.block->name != block) continue;
        forEachNumber(member, [&](std::size_t index, std::size_t offset) {
            if (member.type == permgen::ScalarType::Float) {
                float value = 0.0f;
                std::memcpy(&value, &bytes.at(offset), sizeof value);
                const float next = 0.75f * value + 0.125f + 0.03125f * static_cast<float>(index % 7);
                value = next != value ? next : 0.5f * value;
                std::memcpy(&bytes.at(offset), &value, sizeof value);
            } else {
                // Changes a bool's value, and stays small, because the number may bound a loop.
                std::uint32_t value = 0;
                std::memcpy(&value, &bytes.at(offset), sizeof value);
                value = value == 0 ? 1 : 0;
                std::memcpy(&bytes.at(offset), &value, sizeof value);
            }
        });
    }
    return bytes;
}

}  // namespace tyndall::rig
