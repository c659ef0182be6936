// Adaptive quadrature of smooth functions with values of 0 or more.
//
// Gauss-Kronrod pairs (A. S. Kronrod 1965; R. Piessens et al., QUADPACK, 1983): the Kronrod sum is the value, its
// distance from the embedded Gauss sum the error. That distance is the error of the *lower* rule, so it overstates the
// error by orders of magnitude, and serves as the bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace tyndall::study {

struct Quadrature {
    glm::dvec3 value{0.0};
    glm::dvec3 error{0.0};  ///< absolute, as estimated
    std::uint64_t evaluations = 0;
};

/// Half of a symmetric Gauss-Kronrod pair on [-1, 1]: node 0 is the middle. A node that only Kronrod's rule uses has
/// the Gauss weight 0.
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

/// Integral of `f` over [a, b] to the relative error `accuracy` in every channel, if possible: the piece with the
/// largest error is halved until the sum is accurate enough, until there are `maxPieces` pieces, or until halving no
/// longer helps because only rounding is left. `error` holds the error reached.
///
/// Because values are 0 or more, a sum of integrals has at most the largest of their relative errors.
template <class F>
Quadrature integrate(const F& f, double a, double b, double accuracy, std::size_t maxPieces = 500) {
    const auto accurate = [accuracy](const Quadrature& q) {
        return glm::all(glm::lessThanEqual(q.error, accuracy * glm::abs(q.value)));
    };
    Quadrature total = applyPair(kronrod7, f, a, b);
    if (accurate(total)) return total;
    const std::uint64_t spent = total.evaluations;
    total = applyPair(kronrod15, f, a, b);
    total.evaluations += spent;
    if (accurate(total)) return total;

    struct Piece {
        double a, b, rank;
        Quadrature q;
        bool operator<(const Piece& other) const { return rank < other.rank; }
    };
    const auto piece = [&](double from, double to, const Quadrature& q) {
        double rank = 0.0;  // error of its worst channel, as a share of that channel's sum
        for (int c = 0; c < 3; ++c)
            if (total.value[c] != 0.0) rank = std::max(rank, q.error[c] / std::abs(total.value[c]));
        return Piece{from, to, rank, q};
    };
    constexpr std::size_t patience = 16;
    std::vector<Piece> heap{piece(a, b, total)};
    double best = heap.front().rank;
    for (std::size_t idle = 0; heap.size() < maxPieces && idle < patience && !accurate(total);) {
        std::pop_heap(heap.begin(), heap.end());
        const Piece worst = heap.back();
        heap.pop_back();
        const double middle = 0.5 * (worst.a + worst.b);
        const Quadrature left = applyPair(kronrod15, f, worst.a, middle);
        const Quadrature right = applyPair(kronrod15, f, middle, worst.b);
        heap.push_back(piece(worst.a, middle, left));
        std::push_heap(heap.begin(), heap.end());
        heap.push_back(piece(middle, worst.b, right));
        std::push_heap(heap.begin(), heap.end());

        // Summed anew: adding and subtracting the same value leaves rounding behind.
        const std::uint64_t evaluations = total.evaluations + left.evaluations + right.evaluations;
        total = {};
        double rank = 0.0;
        for (const Piece& p : heap) {
            total.value += p.q.value;
            total.error += p.q.error;
            rank += p.rank;
        }
        total.evaluations = evaluations;
        idle = rank < 0.9 * best ? 0 : idle + 1;
        best = std::min(best, rank);
    }
    return total;
}

}  // namespace tyndall::study
