#include "io/lens_distortion.h"

#include <gtest/gtest.h>

namespace zonegrid {
namespace {

/// A real one: the colour camera of the TUM freiburg1 sequences.
constexpr BrownConrady real_lens{
    .k1 = 0.2624, .k2 = -0.9531, .p1 = -0.0054, .p2 = 0.0026, .k3 = 1.1633};

TEST(LensDistortion, FollowsTheFormula) {
    const Eigen::Vector2d shown = distort({0.5, -0.25}, {0.1, 0.2, 0.3, 0.4, 0.5});
    const double r2 = 0.3125;
    const double radial = 1 + 0.1 * r2 + 0.2 * r2 * r2 + 0.5 * r2 * r2 * r2;
    EXPECT_NEAR(shown.x(), 0.5 * radial + 2 * 0.3 * -0.125 + 0.4 * (r2 + 0.5), 1e-15);
    EXPECT_NEAR(shown.y(), -0.25 * radial + 0.3 * (r2 + 0.125) + 2 * 0.4 * -0.125, 1e-15);
}

TEST(LensDistortion, UndistortsToWhatIsDistorted) {
    int checked = 0;
    for (double x = -0.65; x <= 0.65; x += 0.05) {
        for (double y = -0.5; y <= 0.5; y += 0.05) {
            const Eigen::Vector2d ideal(x, y);
            Eigen::Vector2d found;
            ASSERT_TRUE(undistort(distort(ideal, real_lens), real_lens, found)) << x << " " << y;
            EXPECT_NEAR((found - ideal).norm(), 0.0, 1e-8) << x << " " << y;
            ++checked;
        }
    }
    EXPECT_GT(checked, 500);
}

TEST(LensDistortion, RefusesWhatTheLensCannotShow) {
    // Strong barrel: x (1 - x^2) never exceeds 0.385.
    Eigen::Vector2d found;
    EXPECT_FALSE(undistort({0.5, 0.0}, {.k1 = -1.0}, found));
    EXPECT_TRUE(undistort({0.3, 0.0}, {.k1 = -1.0}, found));
    EXPECT_NEAR(found.x() * (1.0 - found.x() * found.x()), 0.3, 1e-9);
    EXPECT_LT(found.x(), 0.5774); // the inner solution, not the one beyond the fold
}

} // namespace
} // namespace zonegrid
