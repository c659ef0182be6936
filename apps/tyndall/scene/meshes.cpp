#include "meshes.h"

#include <cmath>

#include "accessor.h"

namespace tyndall::app {
namespace {

std::string meshName(const tinygltf::Model& model, std::size_t mesh) {
    const std::string& name = model.meshes[mesh].name;
    return name.empty() ? fmt::format("mesh {}", mesh) : fmt::format("mesh \"{}\"", name);
}

/// Strips and fans as lists: glTF 2.0, section 3.7.2.1.
std::vector<std::uint32_t> asTriangleList(const std::vector<std::uint32_t>& indices, int mode) {
    std::vector<std::uint32_t> list;
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        list = indices;
        list.resize(indices.size() / 3 * 3);
        return list;
    }
    for (std::size_t i = 2; i < indices.size(); ++i) {
        const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
        const std::size_t a = strip ? i - 2 + i % 2 : 0, b = strip ? i - 1 - i % 2 : i - 1;
        list.insert(list.end(), {indices[a], indices[b], indices[i]});
    }
    return list;
}

void computeMissingNormals(Mesh& mesh) {
    std::vector<glm::dvec3> sums(mesh.vertices.size(), glm::dvec3(0.0));
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t* corner = &mesh.indices[i];
        const glm::dvec3 origin(mesh.vertices[corner[0]].position);
        const glm::dvec3 weighted = glm::cross(glm::dvec3(mesh.vertices[corner[1]].position) - origin,
                                               glm::dvec3(mesh.vertices[corner[2]].position) - origin);
        for (int c = 0; c < 3; ++c) sums[corner[c]] += weighted;  // longer for larger triangles
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        glm::vec3& normal = mesh.vertices[i].normal;
        const float given = glm::length(normal);
        if (given > 1e-6f) {
            normal /= given;
            continue;
        }
        const double length = glm::length(sums[i]);
        normal = length > 0.0 ? glm::vec3(sums[i] / length) : glm::vec3(0.0f, 1.0f, 0.0f);
    }
}

Result<Material> readMaterial(const tinygltf::Model& model, int index, bool hasUv, const std::string& user,
                              const ColourTexture& texture) {
    Material material;
    if (index < 0) return material;
    const tinygltf::Material& source = model.materials[static_cast<std::size_t>(index)];
    const std::vector<double>& base = source.pbrMetallicRoughness.baseColorFactor;
    if (base.size() >= 3) material.baseColour = glm::clamp(glm::dvec3(base[0], base[1], base[2]), 0.0, 1.0);
    double strength = 1.0;
    if (const auto found = source.extensions.find("KHR_materials_emissive_strength");
        found != source.extensions.end() && found->second.IsObject() && found->second.Has("emissiveStrength"))
        strength = found->second.Get("emissiveStrength").GetNumberAsDouble();
    const std::vector<double>& glow = source.emissiveFactor;
    if (glow.size() >= 3) material.emissive = strength * glm::dvec3(glow[0], glow[1], glow[2]);
    if (!(strength >= 0.0 && strength <= 1e9) || glm::any(glm::lessThan(material.emissive, glm::vec3(0.0f))) ||
        glm::any(glm::greaterThan(material.emissive, glm::vec3(1e9f))))
        return fail("{}: emission must be between 0 and 1e9; lower it in the material \"{}\"", user, source.name);
    material.doubleSided = source.doubleSided;
    const tinygltf::TextureInfo& info = source.pbrMetallicRoughness.baseColorTexture;
    if (info.index >= 0 && hasUv) {
        auto image = texture(info.index, user);
        if (!image) return tl::unexpected(image.error());
        material.baseTexture = *image;
    }
    return material;
}

Result<Mesh> readPrimitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& user,
                           const ColourTexture& texture) {
    const auto attribute = [&](const char* name) {
        const auto found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? -1 : found->second;
    };
    if (attribute("POSITION") < 0) return fail("{} has no positions; export the file again", user);
    const auto positions = readNumbers(model, attribute("POSITION"), 3, user + ", POSITION");
    if (!positions) return tl::unexpected(positions.error());
    const std::size_t count = positions->size() / 3;

    Result<std::vector<double>> normals, uvs;
    if (attribute("NORMAL") >= 0) normals = readNumbers(model, attribute("NORMAL"), 3, user + ", NORMAL");
    if (!normals) return tl::unexpected(normals.error());
    const int base = primitive.material < 0 ? 0
                                            : model.materials[static_cast<std::size_t>(primitive.material)]
                                                  .pbrMetallicRoughness.baseColorTexture.texCoord;
    const std::string uvName = fmt::format("TEXCOORD_{}", base);
    if (attribute(uvName.c_str()) >= 0) uvs = readNumbers(model, attribute(uvName.c_str()), 2, user + ", " + uvName);
    if (!uvs) return tl::unexpected(uvs.error());
    for (const std::size_t other : {normals->size() / 3, uvs->size() / 2})
        if (other != 0 && other != count)
            return fail("{} has {} positions but {} of another attribute; export the file again", user, count, other);

    Mesh mesh;
    mesh.name = user;
    mesh.vertices.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double* p = positions->data() + 3 * i;
        mesh.vertices[i].position = glm::vec3(p[0], p[1], p[2]);
        if (!normals->empty())
            mesh.vertices[i].normal = glm::vec3((*normals)[3 * i], (*normals)[3 * i + 1], (*normals)[3 * i + 2]);
        if (!uvs->empty()) mesh.vertices[i].uv = glm::vec2((*uvs)[2 * i], (*uvs)[2 * i + 1]);
    }

    std::vector<std::uint32_t> indices(count);
    for (std::size_t i = 0; i < count; ++i) indices[i] = static_cast<std::uint32_t>(i);
    if (primitive.indices >= 0) {
        auto given = readIndices(model, primitive.indices, count, user + ", indices");
        if (!given) return tl::unexpected(given.error());
        indices = std::move(*given);
    }
    mesh.indices = asTriangleList(indices, primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode);
    computeMissingNormals(mesh);

    auto material = readMaterial(model, primitive.material, !uvs->empty(), user, texture);
    if (!material) return tl::unexpected(material.error());
    mesh.material = *material;
    return mesh;
}

}  // namespace

Result<std::vector<Mesh>> readMesh(const tinygltf::Model& model, std::size_t index, const ColourTexture& texture,
                                   std::vector<std::string>& warnings) {
    std::vector<Mesh> meshes;
    for (const tinygltf::Primitive& primitive : model.meshes[index].primitives) {
        const std::string user = meshName(model, index);
        if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) {
            warnings.push_back(user + " has points or lines, which are not drawn");
            continue;
        }
        if (!primitive.targets.empty()) warnings.push_back(user + " has morph targets; it is drawn in its rest shape");
        if (primitive.material >= 0 &&
            model.materials[static_cast<std::size_t>(primitive.material)].alphaMode != "OPAQUE")
            warnings.push_back(user + " has a transparent material; it is drawn opaque and casts shadows");
        auto mesh = readPrimitive(model, primitive, user, texture);
        if (!mesh) return tl::unexpected(mesh.error());
        if (!mesh->indices.empty()) meshes.push_back(std::move(*mesh));
    }
    return meshes;
}

}  // namespace tyndall::app
