// The rays that raycast.fx follows, and the outline that it is drawn over.
#include "raycast/view_rays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "raycast/outline.h"

namespace tyndall {
namespace {

struct NamedView {
    const char* name;
    View view;
};

glm::dmat4 somewhere() {
    glm::dmat4 pose(1.0);
    const double c = std::cos(0.7), s = std::sin(0.7);
    pose[0] = {c, 0.0, -s, 0.0};
    pose[2] = {s, 0.0, c, 0.0};
    pose[3] = {3.0, -1.0, 2.0, 1.0};
    return pose;
}

std::vector<NamedView> views() {
    std::vector<NamedView> all{
        {"perspective", perspectiveView(somewhere(), 1.1, 1.6, 0.1, 50.0)},
        {"endless", perspectiveView(somewhere(), 0.4, 1.0, 0.1, INFINITY)},
        {"orthographic", orthographicView(somewhere(), 3.0, 2.0, 0.1, 50.0)},
        {"shifted", perspectiveView(somewhere(), 1.1, 1.6, 0.1, 50.0)},
        {"rotated", perspectiveView(somewhere(), 1.1, 1.6, 0.1, 50.0)},
        {"doubled", perspectiveView(somewhere(), 1.1, 1.6, 0.1, 50.0)},
        {"off_centre", orthographicView(somewhere(), 3.0, 2.0, 0.1, 50.0)},
    };
    glm::dmat4& shifted = all[3].view.clipFromView;
    shifted[2][0] = 0.3;
    shifted[2][1] = -0.2;
    glm::dmat4& rotated = all[4].view.clipFromView;
    glm::dmat4 turn(1.0);
    turn[0] = {0.6, 0.8, 0.0, 0.0};
    turn[1] = {-0.8, 0.6, 0.0, 0.0};
    rotated = turn * rotated;
    all[5].view.clipFromView = 2.0 * all[5].view.clipFromView;  // the same picture
    all[6].view.clipFromView[3][0] = 0.4;
    return all;
}

class ViewRaysTest : public testing::TestWithParam<NamedView> {};
INSTANTIATE_TEST_SUITE_P(Views, ViewRaysTest, testing::ValuesIn(views()),
                         [](const auto& test) { return std::string(test.param.name); });

// Projecting a point of a pixel's ray gives the pixel, and the stored depth that ViewRays promises.
TEST_P(ViewRaysTest, PassThroughTheirPixels) {
    const View& view = GetParam().view;
    glm::dmat4 worldFromLight(1.0);
    worldFromLight[3] = {-2.0, 4.0, 1.0, 1.0};
    const LightPose pose = lightPose(worldFromLight, view.worldFromView);
    const ViewRays rays = viewRays(view, pose);
    for (const double x : {-0.9, 0.0, 0.4})
        for (const double y : {-0.7, 0.1, 1.0})
            for (const double depth : {0.2, 1.0, 30.0}) {
                const glm::dvec4 origin = rays.origin[0] + x * rays.origin[1] + y * rays.origin[2];
                const glm::dvec4 direction = rays.direction[0] + x * rays.direction[1] + y * rays.direction[2];
                const glm::dvec4 point = origin + depth * direction;
                const glm::dvec4 inView = pose.viewFromLight * glm::dvec4(glm::dvec3(point), 1.0);
                EXPECT_NEAR(-inView.z, depth, 1e-12 * depth + 1e-12);
                const glm::dvec4 clip = view.clipFromView * inView;
                EXPECT_NEAR(clip.x / clip.w, x, 1e-12);
                EXPECT_NEAR(clip.y / clip.w, y, 1e-12);
                EXPECT_NEAR(point.w / (rays.scale.x + depth * rays.scale.y), clip.z / clip.w, 1e-12);
            }
}

// Corners of boxes before the eye: none lies outside of the outline, which is convex and reaches to within twice the
// margin of a corner at every of its own.
TEST(Outline, IsTheConvexHullOfTheCorners) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-0.9, 0.9), depth(2.0, 6.0);
    const View view = perspectiveView(glm::dmat4(1.0), 1.2, 1.0, 0.1, 50.0);
    constexpr double margin = 1e-3;
    for (int round = 0; round < 200; ++round) {
        std::array<glm::dvec3, 8> corners;
        const glm::dvec3 middle(place(random), place(random), -depth(random));
        for (std::size_t i = 0; i < 8; ++i)
            corners[i] = middle + 0.3 * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1) +
                         0.1 * glm::dvec3(place(random), place(random), place(random));
        std::vector<glm::dvec2> outline{{7.0, 7.0}};  // of another light
        appendOutline(outline, hexahedron(corners), view, margin);
        ASSERT_EQ(outline.front(), glm::dvec2(7.0));
        outline.erase(outline.begin());
        ASSERT_GE(outline.size(), 4u);
        std::vector<glm::dvec2> shown;
        for (const glm::dvec3& corner : corners) {
            const glm::dvec4 clip = view.clipFromView * glm::dvec4(corner, 1.0);
            shown.push_back(glm::dvec2(clip) / clip.w);
        }
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()], along = b - a;
            for (const glm::dvec2& p : shown) EXPECT_GT(along.x * (p.y - a.y) - along.y * (p.x - a.x), 0.0);
            double nearest = 1.0;
            for (const glm::dvec2& p : shown) nearest = std::min(nearest, glm::length(a - p));
            EXPECT_LE(nearest, 2.0 * margin);
        }
    }
}

TEST(Outline, StaysInThePicture) {
    const View view = perspectiveView(glm::dmat4(1.0), 1.2, 1.0, 0.1, 50.0);
    std::array<glm::dvec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = {i & 1 ? 5.0 : -5.0, i & 2 ? 5.0 : -5.0, i & 4 ? -3.0 : -2.0};
    std::vector<glm::dvec2> outline, picture;
    appendOutline(outline, hexahedron(corners), view, 1e-3);
    appendPicture(picture);
    EXPECT_EQ(outline, picture);
}

}  // namespace
}  // namespace tyndall
