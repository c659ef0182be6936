// A full container throws, and the planner's caller gets an Error.
#include "geometry/capacity.h"

#include <gtest/gtest.h>

#include "geometry/convex_polyhedron.h"
#include "geometry/inline_vector.h"
#include "geometry/slice_polygon.h"
#include "plan_scenes.h"
#include "visibility/light_volume.h"

namespace tyndall {
namespace {

using namespace test;

TEST(InlineVector, ThrowsWhereItIsFullAndKeepsItsEntries) {
    InlineVector<int, 3> three;
    for (int i = 0; i < 3; ++i) three.push_back(i);
    EXPECT_THROW(three.push_back(3), CapacityExceeded);
    EXPECT_THROW(three.resize(4), CapacityExceeded);
    ASSERT_EQ(three.size(), 3u);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(three[static_cast<std::size_t>(i)], i);
    three.resize(2);
    three.push_back(7);
    EXPECT_EQ(three[2], 7);
}

void overfill() {
    InlineVector<int, 2> two;
    for (int i = 0; i < 3; ++i) two.push_back(i);
}

TEST(CapacityExceeded, NamesTheFunctionAndTheCapacityInTheAnswer) {
    try {
        overfill();
        FAIL() << "three entries in a vector of two";
    } catch (const CapacityExceeded& exceeded) {
        const Error error = internalError(exceeded);
        EXPECT_EQ(error.code, ErrorCode::Internal);
        EXPECT_EQ(error.message.find("internal: "), 0u) << error.message;
        EXPECT_NE(error.message.find("overfill"), std::string::npos) << error.message;
        EXPECT_NE(error.message.find("holds 2 entries"), std::string::npos) << error.message;
        EXPECT_NE(error.message.find("report it"), std::string::npos) << error.message;
    }
}

// A regular polygon by as many half planes as it has sides.
SlicePolygon polygonOf(int sides) {
    std::vector<glm::dvec4> planes;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * glm::pi<double>() * i / sides;
        planes.push_back({std::cos(angle), std::sin(angle), 0.0, 1.0});
    }
    return slicePolygon(glm::dvec2(-2.0), glm::dvec2(2.0), planes, 1.0);
}

TEST(SlicePolygon, ThrowsWhereACornerWouldBeLost) {
    constexpr int capacity = static_cast<int>(SlicePolygon::capacity);
    EXPECT_EQ(polygonOf(capacity).count, SlicePolygon::capacity);
    EXPECT_THROW(polygonOf(capacity + 1), CapacityExceeded);
    SlicePolygon inside, outside;
    // Cuts off one corner: the rest gains a corner.
    const SlicePolygon full = polygonOf(capacity);
    const glm::dvec2 towards = glm::normalize(full.corners[0]);
    const double offset = glm::length(full.corners[0]) - 1e-4;
    EXPECT_THROW(split(full, -towards, offset, inside, outside), CapacityExceeded);
}

TEST(ConvexPolyhedron, ThrowsWhereAFaceWouldBeLost) {
    std::array<glm::dvec3, 8> corners;
    for (int i = 0; i < 8; ++i) corners[i] = {(i & 1) ? 2.0 : -2.0, (i & 2) ? 2.0 : -2.0, (i & 4) ? 2.0 : -2.0};
    ConvexPolyhedron solid = hexahedron(corners);
    const auto side = [](std::size_t i) {
        const double angle = 2.0 * glm::pi<double>() * static_cast<double>(i) / 31.0;
        return glm::dvec4(std::cos(angle), std::sin(angle), 0.0, 1.0);
    };
    for (std::size_t i = 6; i < ConvexPolyhedron::maxFaces; ++i) ASSERT_TRUE(cut(solid, side(i - 6), 1e-9));
    EXPECT_EQ(solid.faces, ConvexPolyhedron::maxFaces);
    EXPECT_TRUE(cut(solid, {0.0, 0.0, 1.0, 5.0}, 1e-9)) << "cuts nothing off and adds no face";
    EXPECT_THROW(cut(solid, side(30), 1e-9), CapacityExceeded);
}

// The capacity suffices for the maximum number of clip planes, with walls and a beam.
TEST(LightVolume, HasRoomForEveryPlaneThatALightMayBring) {
    Light light = projector();
    for (std::size_t i = 0; i < maxClipPlanes; ++i) {
        const double angle = static_cast<double>(i);
        light.clipPlanes.push_back({std::cos(angle), std::sin(angle), 0.0, 0.3});
    }
    const View view = wideView(glm::dmat4(1.0));
    EXPECT_EQ(planned({light}, view, slices(8)).lights[0].verdict, Verdict::Drawn);
    ConvexPolyhedron seen;
    const LightPose pose = lightPose(light.worldFromLight, view.worldFromView);
    EXPECT_EQ(boundingPlanes(lightVolume(light, view, pose, {}, {}, seen)).size(), 6 + maxClipPlanes);
    light.clipPlanes.push_back({0.0, 0.0, 1.0, 3.0});
    EXPECT_FALSE(plan(std::span(&light, 1), view, slices(8)).has_value()) << "checked before any plane is added";
}

}  // namespace
}  // namespace tyndall
