// Bounds of a light's attenuation, against rays across its axis, whose integral has a closed form.
#include "shape/attenuation.h"

#include <gtest/gtest.h>

#include "plan_scenes.h"

namespace tyndall {
namespace {

using namespace test;

TEST(Attenuation, IsLargestAtTheNearPlane) {
    Light light = projector();  // 100 cd, from 0.5 m
    light.ambient = 3.0;
    EXPECT_DOUBLE_EQ(maxAttenuation(light), 403.0);
}

// The integral of dt / (D^2 + t^2) from -L / 2 to L / 2 is 2 atan(L / 2 D) / D; slabs add to it at their midpoints. The
// bound is loosest at L = 4 D: by 2 / atan(2) = 1.81.
TEST(Attenuation, IsBoundedAlongARayAndOverItsSlabs) {
    Light light = projector();
    light.ambient = 0.2;
    for (const double distance : {0.5, 2.0, 5.0})
        for (const double length : {0.01, 0.3, 1.0, 10.0, 300.0}) {
            const double integral =
                light.intensity * 2.0 * std::atan(0.5 * length / distance) / distance + light.ambient * length;
            const double bound = maxAttenuationAlong(light, distance, length, 0.0);
            EXPECT_GE(bound, integral) << distance << " m, over " << length;
            EXPECT_LE(bound, 1.82 * integral) << distance << " m, over " << length;
            for (const int slabs : {1, 3, 17}) {
                const double slab = length / slabs;
                double sum = 0.0;
                for (int i = 0; i < slabs; ++i) {
                    const double t = (i + 0.5) * slab - 0.5 * length;
                    sum += slab * (light.intensity / (distance * distance + t * t) + light.ambient);
                }
                EXPECT_GE(maxAttenuationAlong(light, distance, length, slab) * (1.0 + 1e-12), sum) << slabs;
            }
        }
}

}  // namespace
}  // namespace tyndall
