#include <tyndall/air.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace tyndall {

double extinction(const Light& light) {
    return light.albedo ? light.density / *light.albedo : 0.0;
}

double phase(double g, double angle) {
    const double strength = std::abs(g), narrow = 1.0 - strength;
    const double half = std::sin(0.5 * (g < 0.0 ? glm::pi<double>() - angle : angle));
    const double base = narrow * narrow + 4.0 * strength * half * half;
    return narrow / base * ((1.0 + strength) / std::sqrt(base));
}

}  // namespace tyndall
