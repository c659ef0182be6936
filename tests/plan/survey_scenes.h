// Meshes and instances for the tests of surveys.
#pragma once

#include <gtest/gtest.h>
#include <tyndall/meshes.h>
#include <tyndall/result.h>

#include "plan_scenes.h"

namespace tyndall::test {

/// A vertex as engines have them: the position is not all of it.
struct SurveyVertex {
    glm::vec2 uv{0.0f};
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};
};

struct SurveyMesh {
    std::vector<SurveyVertex> vertices;
    std::vector<std::uint32_t> indices;

    void addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        for (const glm::vec3& corner : {a, b, c}) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.push_back({{}, corner, {}});
        }
    }
    /// Two triangles that share an edge.
    void addRectangle(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const glm::vec3& p : {corner, corner + u, corner + u + v, corner + v}) vertices.push_back({{}, p, {}});
        for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
    }
};

struct SurveyScene {
    std::vector<SurveyMesh> meshes;
    std::vector<MeshInstance> instances;

    std::vector<MeshTriangles> triangles() const {
        std::vector<MeshTriangles> all;
        for (const SurveyMesh& mesh : meshes)
            all.push_back({mesh.vertices.empty() ? nullptr : &mesh.vertices[0].position, mesh.vertices.size(),
                           sizeof(SurveyVertex), mesh.indices});
        return all;
    }
    std::vector<std::array<glm::vec3, 3>> trianglesOf(std::size_t mesh) const {
        const SurveyMesh& from = meshes.at(mesh);
        std::vector<std::array<glm::vec3, 3>> all;
        for (std::size_t i = 0; i < from.indices.size(); i += 3)
            all.push_back({from.vertices.at(from.indices[i]).position, from.vertices.at(from.indices[i + 1]).position,
                           from.vertices.at(from.indices[i + 2]).position});
        return all;
    }
};

inline std::array<float, 9> numbersOf(const std::array<glm::vec3, 3>& t) {
    return {t[0].x, t[0].y, t[0].z, t[1].x, t[1].y, t[1].z, t[2].x, t[2].y, t[2].z};
}

/// Four meshes of 0, 3, 40 and 3000 triangles anyhow, and two instances of each.
inline SurveyScene randomSurveyScene(unsigned seed) {
    Random random(seed);
    SurveyScene scene;
    for (const int count : {0, 3, 40, 3000}) {
        SurveyMesh& mesh = scene.meshes.emplace_back();
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 middle = inCube(random, 3.0);
            const auto corner = [&] { return glm::vec3(middle + inCube(random, 0.3)); };
            const glm::vec3 a = corner(), b = corner();
            mesh.addTriangle(a, b, corner());
        }
    }
    for (std::size_t i = 0; i < 8; ++i) {
        glm::dmat4 worldFromMesh = rigidMotion(random, 20.0);
        worldFromMesh[0] *= between(random, 0.2, 3.0);
        worldFromMesh[1] += 0.4 * worldFromMesh[2];
        scene.instances.push_back({i % 4, worldFromMesh});
    }
    return scene;
}

/// `make`: a factory of meshes and instances. Every message begins with `place`.
template <class Make>
void expectMeshesRefused(Make make, const std::string& place) {
    const SurveyScene whole = randomSurveyScene(1);
    const auto expectRefused = [&](auto change, const std::string& words) {
        SurveyScene scene = whole;
        std::vector<MeshTriangles> meshes = scene.triangles();
        change(scene, meshes);
        const auto made = make(meshes, scene.instances);
        ASSERT_FALSE(made) << words;
        EXPECT_EQ(made.error().code, ErrorCode::InvalidArgument);
        EXPECT_EQ(made.error().message.find(place + words), 0u) << made.error().message;
    };
    EXPECT_TRUE(make(whole.triangles(), whole.instances));
    constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
    using Meshes = std::vector<MeshTriangles>;
    expectRefused([](SurveyScene&, Meshes& m) { m[1].stride = 8; }, "mesh 1 has a stride of 8 bytes");
    expectRefused([](SurveyScene&, Meshes& m) { m[2].indices = m[2].indices.first(7); }, "mesh 2 has 7 indices");
    expectRefused([](SurveyScene&, Meshes& m) { m[1].vertices = 5; }, "mesh 1 has the index 5 with 5 vertices");
    expectRefused([](SurveyScene& s, Meshes&) { s.meshes[3].vertices[8].position.y = notANumber; },
                  "mesh 3 has a corner at (");
    expectRefused([](SurveyScene& s, Meshes&) { s.instances[5].mesh = 4; }, "instance 5 is of mesh 4 of 4 meshes");
    expectRefused([](SurveyScene& s, Meshes&) { s.instances[2].worldFromMesh[0].x = notANumber; },
                  "instance 2 has a worldFromMesh that is not affine");
    expectRefused([](SurveyScene& s, Meshes&) { s.instances[2].worldFromMesh[2].w = 0.5; },
                  "instance 2 has a worldFromMesh that is not affine");
}

}  // namespace tyndall::test
