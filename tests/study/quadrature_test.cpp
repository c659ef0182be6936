// The rules and the substitution of the reference.
#include "quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "inverse_square.h"

namespace tyndall::study {
namespace {

template <std::size_t N>
double momentError(const KronrodNode (&nodes)[N], int degree, bool gauss) {
    double sum = 0.0;
    for (std::size_t i = 0; i < N; ++i)
        sum += (i == 0 ? 1.0 : 2.0) * (gauss ? nodes[i].gauss : nodes[i].kronrod) * std::pow(nodes[i].x, degree);
    return std::abs(sum - 2.0 / (degree + 1.0));
}

// A rule of degree d integrates every power up to d exactly, and fails at the next even one: this reveals any wrong
// digit.
template <std::size_t N>
void expectDegree(const KronrodNode (&nodes)[N], int degree, bool gauss) {
    for (int power = 0; power <= degree; power += 2) EXPECT_LT(momentError(nodes, power, gauss), 1e-15) << power;
    EXPECT_GT(momentError(nodes, degree + degree % 2 + (degree % 2 == 0 ? 2 : 0), gauss), 1e-9);
}

TEST(Quadrature, RulesHaveTheDegreeThatTheoryGives) {
    expectDegree(kronrod7, 5, true);
    expectDegree(kronrod7, 11, false);
    expectDegree(kronrod15, 13, true);
    expectDegree(kronrod15, 23, false);
}

// Halving the interval of a rule of degree 11 divides its error by 2^12 in the sum of both halves.
TEST(Quadrature, ConvergesWithTheExpectedOrder) {
    const auto f = [](double x) { return glm::dvec3(1.0 / (1.0 + 4.0 * x * x)); };
    const auto error = [&](int pieces) {
        double sum = 0.0;
        for (int i = 0; i < pieces; ++i)
            sum += applyPair(kronrod7, f, static_cast<double>(i) / pieces, (i + 1.0) / pieces).value.x;
        return std::abs(sum - 0.5 * std::atan(2.0));
    };
    const double order = std::log2(error(2) / error(4));
    EXPECT_GT(order, 9.0);
    EXPECT_LT(order, 15.0);
    EXPECT_LT(error(8), 1e-15);
}

TEST(Quadrature, TheErrorItStatesHolds) {
    for (const double accuracy : {1e-3, 1e-6, 1e-10}) {
        // Functions with kinks, peaks and oscillations; none is negative.
        const auto f = [](double x) {
            return glm::dvec3(std::abs(x - 0.3), 1.0 / (1e-4 + x * x), 1.0 + std::cos(40.0 * x));
        };
        const glm::dvec3 exact(0.5 * (0.09 + 0.49), 100.0 * std::atan(100.0), 1.0 + std::sin(40.0) / 40.0);
        const Quadrature q = integrate(f, 0.0, 1.0, accuracy);
        for (int c = 0; c < 3; ++c) {
            EXPECT_LE(std::abs(q.value[c] - exact[c]), q.error[c] + 1e-14 * exact[c]) << accuracy << " " << c;
            EXPECT_LE(q.error[c], accuracy * q.value[c]) << accuracy << " " << c;
        }
    }
}

TEST(Quadrature, GivesUpAtAJumpAndSaysSo) {
    const auto step = [](double x) { return glm::dvec3(x < 1.0 / 3.0 ? 1.0 : 0.0); };
    const Quadrature q = integrate(step, 0.0, 1.0, 1e-12, 20);
    EXPECT_GT(q.error.x, 1e-12);
    EXPECT_NEAR(q.value.x, 1.0 / 3.0, q.error.x);
}

// Noise of 1e-9 simulates rounding: 1e-12 cannot be reached, and the result still comes with its error.
TEST(Quadrature, GivesUpAtRoundingAndSaysSo) {
    const auto noisy = [](double x) { return glm::dvec3(x * (1.0 + 1e-9 * std::sin(1e9 * x))); };
    const Quadrature q = integrate(noisy, 0.0, 1.0, 1e-12);
    EXPECT_LT(q.evaluations, 2000u);
    EXPECT_GT(q.error.x, 1e-12 * q.value.x);
    EXPECT_NEAR(q.value.x, 0.5, q.error.x + 1e-10);
}

long double wellConditioned(long double a, long double b, long double h) {
    return (std::atan(b / h) - std::atan(a / h)) / h;
}

TEST(InverseSquare, MeetsTheClosedForm) {
    for (const double h : {0.3, 1.0, 7.0})
        for (const double a : {-9.0, -0.5, 0.0, 0.1, 2.0})
            for (const double length : {1e-3, 0.2, 1.0, 30.0}) {
                const double exact = static_cast<double>(wellConditioned(a, a + length, h));
                EXPECT_NEAR(inverseSquareIntegral(a, a + length, h), exact, 1e-13 * exact) << h << " " << a;
            }
}

// Next to the lamp: the limit is 1/a - 1/b if the ray runs through it, and it is approached continuously. A difference
// of two arcs of nearly 90 degrees loses all digits of a double here.
TEST(InverseSquare, IsStableNextToTheLight) {
    const double limit = 1.0 / 0.05 - 1.0 / 10.0;
    EXPECT_DOUBLE_EQ(inverseSquareIntegral(0.05, 10.0, 0.0), limit);
    EXPECT_DOUBLE_EQ(inverseSquareIntegral(-10.0, -0.05, 0.0), limit);
    for (double h = 1e-2; h > 1e-300; h *= 1e-3) {
        // The first term of the series in h leaves h^2 / (3 a^2) of the value.
        const double value = inverseSquareIntegral(0.05, 10.0, h);
        EXPECT_NEAR(value, limit, limit * (h * h / (0.05 * 0.05) + 1e-15)) << h;
        const double through = inverseSquareIntegral(-10.0, 10.0, h);
        EXPECT_NEAR(through * h, std::acos(-1.0), 0.21 * h + 1e-15) << h;
    }
}

// In a shader's floats the plain difference loses all digits at 10 m along the ray and 10 um off the lamp.
TEST(InverseSquare, ThePlainFormWouldNotDo) {
    const float h = 1e-5f, a = 10.0f, b = 10.5f;
    const float plain = (std::atan(b / h) - std::atan(a / h)) / h;
    const double exact = 0.5 / 105.0;
    EXPECT_GT(std::abs(static_cast<double>(plain) - exact), 0.4 * exact);
    EXPECT_NEAR(inverseSquareIntegral(10.0, 10.5, 1e-5), exact, 1e-11 * exact);
}

TEST(AngleFromLamp, IntegratesAsTheVariableItStandsFor) {
    for (const double h : {0.0, 1e-12, 1e-6, 1e-3, 0.1, 1.0, 20.0})
        for (const auto& [a, b] : {std::pair{0.5, 0.6}, {0.05, 12.0}, {-12.0, -0.05}, {-3.0, -2.9}}) {
            const AngleFromLamp angle(a, b, h);
            EXPECT_NEAR(angle.at(0.0), a, 1e-13 * std::abs(a));
            EXPECT_NEAR(angle.at(1.0), b, 1e-12 * std::abs(b));
            // g = (h^2 + s^2) s^2 has the integral (b^3 - a^3) / 3.
            const auto f = [&](double x) {
                const double s = angle.at(x);
                return glm::dvec3((h * h + s * s) * s * s);
            };
            const double exact = (b * b * b - a * a * a) / 3.0;
            EXPECT_NEAR(angle.measure() * integrate(f, 0.0, 1.0, 1e-12).value.x, exact, 1e-10 * exact) << h << " " << a;
        }
    const AngleFromLamp touching(0.0, 2.0, 0.25);  // from the foot itself
    EXPECT_EQ(touching.at(0.0), 0.0);
    EXPECT_NEAR(touching.at(0.5), 0.25 * std::tan(0.5 * std::atan(8.0)), 1e-15);
}

}  // namespace
}  // namespace tyndall::study
