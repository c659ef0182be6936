// The slide's projection: the corners of the field of view are the corners of the slide.
#include "shape/slide.h"

#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

std::vector<LightShape> shapes() {
    std::vector<LightShape> all;
    for (const glm::dvec2 fov : {glm::dvec2(40.0, 24.0), glm::dvec2(0.01, 0.01), glm::dvec2(179.0, 0.01)}) {
        Light light = projector();
        light.fov = fov * degrees;
        all.push_back(shapeOf(light));
    }
    return all;
}

TEST(Slide, HasItsCornersInThoseOfTheFieldOfView) {
    for (const LightShape& shape : shapes()) {
        const std::array<glm::dvec3, 4> corners = cornersAt(shape, 2.0);
        const glm::dvec2 uv[] = {{0, 1}, {1, 1}, {0, 0}, {1, 0}};  // v runs down
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec2 slope = slopeOf(shape, corners[i]);
            EXPECT_LT(glm::distance(slideFromSlope(shape, slope), uv[i]), 1e-15) << i;
            EXPECT_LT(glm::distance(slopeFromSlide(shape, uv[i]), slope), 1e-15 * glm::length(slope)) << i;
        }
        const SlideRange all = slideFromSlopes(shape, slopesOf(shape));
        EXPECT_LT(glm::length(all.min), 1e-15);
        EXPECT_LT(glm::distance(all.max, glm::dvec2(1.0)), 1e-15);
    }
}

TEST(Slide, ComesBackFromTheAir) {
    Random random(1);
    for (const LightShape& shape : shapes())
        for (int i = 0; i < 100; ++i) {
            const glm::dvec2 uv(between(random, -0.5, 1.5), between(random, -0.5, 1.5));
            const glm::dvec3 point = pointAt(shape, slopeFromSlide(shape, uv), between(random, 0.5, 6.0));
            EXPECT_LT(glm::distance(slideFromSlope(shape, slopeOf(shape, point)), uv), 1e-14);
        }
}

TEST(Slide, IsBoundedByPlanesThroughTheLamp) {
    Random random(2);
    for (const LightShape& shape : shapes())
        for (int i = 0; i < 100; ++i) {
            const glm::dvec2 direction(between(random, -1.0, 1.0), between(random, -1.0, 1.0));
            const glm::dvec2 uv(between(random, 0.0, 1.0), between(random, 0.0, 1.0));
            const double axis = between(random, 0.5, 6.0), off = between(random, -0.3, 0.3);
            const glm::dvec4 plane = slidePlane(shape, direction, glm::dot(direction, uv) - off);
            const glm::dvec3 point(axis * (uv.x - 0.5) * 2.0 * shape.tanHalfFov.x,
                                   axis * (0.5 - uv.y) * 2.0 * shape.tanHalfFov.y, -axis);
            EXPECT_NEAR(glm::dot(plane, glm::dvec4(point, 1.0)), axis * off, 1e-13);
        }
}

}  // namespace
}  // namespace tyndall
