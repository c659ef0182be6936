#include "accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tyndall::app {
namespace {

template <class T>
double number(const unsigned char* bytes, bool normalized) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    if constexpr (std::is_integral_v<T>) {
        if (normalized)
            return std::max(-1.0, static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()));
    }
    return static_cast<double>(value);
}

double read(int type, const unsigned char* bytes, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return number<std::int8_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return number<std::uint8_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return number<std::int16_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return number<std::uint16_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return number<std::uint32_t>(bytes, normalized);
        default:
            return number<float>(bytes, normalized);
    }
}

struct Elements {
    const unsigned char* first;
    std::size_t stride, componentBytes;
};

Elements elements(const tinygltf::Model& model, const tinygltf::Accessor& accessor) {
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    const tinygltf::Buffer& buffer = model.buffers[static_cast<std::size_t>(view.buffer)];
    return {buffer.data.data() + view.byteOffset + accessor.byteOffset,
            static_cast<std::size_t>(accessor.ByteStride(view)),
            static_cast<std::size_t>(
                tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)))};
}

}  // namespace

Result<std::vector<double>> readNumbers(const tinygltf::Model& model, int accessor, int components,
                                        const std::string& what) {
    const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
    const int stored = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
    if (stored != components)
        return fail("{} has {} components instead of {}; export the file again", what, stored, components);
    const Elements from = elements(model, source);
    std::vector<double> values;
    values.reserve(source.count * static_cast<std::size_t>(components));
    for (std::size_t i = 0; i < source.count; ++i)
        for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c) {
            const double value =
                read(source.componentType, from.first + i * from.stride + c * from.componentBytes, source.normalized);
            if (!std::isfinite(value))
                return fail("{} holds a value that is not finite (element {}); repair the model and export it again",
                            what, i);
            values.push_back(value);
        }
    return values;
}

Result<std::vector<std::uint32_t>> readIndices(const tinygltf::Model& model, int accessor, std::size_t vertexCount,
                                               const std::string& what) {
    const tinygltf::Accessor& source = model.accessors[static_cast<std::size_t>(accessor)];
    const bool whole = source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                       source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                       source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!whole || source.type != TINYGLTF_TYPE_SCALAR)
        return fail("{} must be unsigned whole numbers; export the file again", what);
    const Elements from = elements(model, source);
    std::vector<std::uint32_t> indices(source.count);
    for (std::size_t i = 0; i < source.count; ++i) {
        const double value = read(source.componentType, from.first + i * from.stride, false);
        if (value >= static_cast<double>(vertexCount))
            return fail("{} point at vertex {} of {}; export the file again", what, static_cast<std::uint64_t>(value),
                        vertexCount);
        indices[i] = static_cast<std::uint32_t>(value);
    }
    return indices;
}

}  // namespace tyndall::app
