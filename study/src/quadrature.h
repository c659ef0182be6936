// Adaptive quadrature of smooth functions that are nowhere negative.
//
// Gauss-Kronrod pairs (A. S. Kronrod 1965; R. Piessens et al., QUADPACK, 1983): the Kronrod sum is the value, its
// distance from the embedded Gauss sum the error. That distance is the error of the *lower* rule, so it
// overstates by orders of magnitude what is lost, and is used as the bound as it stands.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace tyndall::study {

struct Quadrature {
    glm::dvec3 value{0.0};
    glm::dvec3 error{0.0};  ///< absolute, as estimated
    std::uint64_t evaluations = 0;
};

/// Half of a symmetric Gauss-Kronrod pair on [-1, 1]: node 0 is the middle. Gauss weights are 0 where the
/// node is Kronrod's alone.
struct KronrodNode {
    double x, kronrod, gauss;
};

/// 3 and 7 points; exact to degree 5 and 10 (11 by symmetry).
inline constexpr KronrodNode kronrod7[] = {
    {0.0, 0.450916538658474142345110087045571, 0.888888888888888888888888888888889},
    {0.434243749346802558002071502844628, 0.401397414775962222905051818618432, 0.0},
    {0.774596669241483377035853079956480, 0.268488089868333440728569280666710, 0.555555555555555555555555555555556},
    {0.960491268708020283423507092629080, 0.104656226026467265193823857192073, 0.0},
};

/// 7 and 15 points; exact to degree 13 and 22 (23 by symmetry).
inline constexpr KronrodNode kronrod15[] = {
    {0.0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327},
    {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
    {0.405845151377397166906606412076961, 0.190350578064785409913256402421014, 0.381830050505118944950369775488975},
    {0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0},
    {0.741531185599394439863864773280788, 0.140653259715525918745189590510238, 0.279705391489276667901467771423780},
    {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
    {0.949107912342758524526189684047851, 0.063092092629978553290700663189204, 0.129484966168869693270611432679082},
    {0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0},
};

/// One pair applied to the integral of `f` (double -> dvec3) over [a, b].
template <class F, std::size_t N>
Quadrature applyPair(const KronrodNode (&nodes)[N], const F& f, double a, double b) {
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a);
    const glm::dvec3 centre = f(middle);
    glm::dvec3 kronrod = nodes[0].kronrod * centre, gauss = nodes[0].gauss * centre;
    for (std::size_t i = 1; i < N; ++i) {
        const glm::dvec3 pair = f(middle - half * nodes[i].x) + f(middle + half * nodes[i].x);
        kronrod += nodes[i].kronrod * pair;
        gauss += nodes[i].gauss * pair;
    }
    return {half * kronrod, glm::abs(half * (kronrod - gauss)), 2 * N - 1};
}

/// Integral of `f` over [a, b] to the relative error `accuracy` in every channel. Because nothing is negative,
/// pieces that are each as accurate as asked for add up to a whole that is. The interval is halved where the
/// pair disagrees, at most `depth` times; what is not reached then shows in `error`.
template <class F>
Quadrature integrate(const F& f, double a, double b, double accuracy, int depth = 40) {
    const auto goodEnough = [&](const Quadrature& q) {
        return glm::all(glm::lessThanEqual(q.error, accuracy * glm::abs(q.value)));
    };
    Quadrature q = applyPair(kronrod7, f, a, b);
    if (goodEnough(q)) return q;
    const std::uint64_t spent = q.evaluations;
    q = applyPair(kronrod15, f, a, b);
    q.evaluations += spent;
    const double middle = 0.5 * (a + b);
    if (goodEnough(q) || depth == 0 || !(a < middle && middle < b)) return q;
    const Quadrature left = integrate(f, a, middle, accuracy, depth - 1);
    const Quadrature right = integrate(f, middle, b, accuracy, depth - 1);
    return {left.value + right.value, left.error + right.error, q.evaluations + left.evaluations + right.evaluations};
}

}  // namespace tyndall::study
