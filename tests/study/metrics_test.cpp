// The figures of a comparison: closed forms of tiny pictures, and laws.
#include <gtest/gtest.h>
#include <study/metrics.h>

#include <limits>

namespace tyndall::study {
namespace {

TEST(NonFiniteValues, AreCountedWithTheFirstPlace) {
    FloatImage image{3, 2, 2, std::vector<float>(12, 1.0f)};
    EXPECT_EQ(countNonFinite(image).count(), 0u);
    EXPECT_FALSE(countNonFinite(image).first);
    image.values[7] = std::numeric_limits<float>::quiet_NaN();  // pixel 3 is (0, 1)
    image.values[10] = -std::numeric_limits<float>::infinity();
    image.values[11] = std::numeric_limits<float>::infinity();
    const NonFinite found = countNonFinite(image);
    EXPECT_EQ(found.nan, 1u);
    EXPECT_EQ(found.infinite, 2u);
    ASSERT_TRUE(found.first);
    EXPECT_EQ(found.first->x, 0);
    EXPECT_EQ(found.first->y, 1);
    EXPECT_EQ(found.first->channel, 1);
}

}  // namespace
}  // namespace tyndall::study
