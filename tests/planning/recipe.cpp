#include "recipe.h"

#include <ostream>

namespace tyndall::test {
namespace {

std::ostream& operator<<(std::ostream& out, const LightRecipe& l) {
    constexpr const char* slides[] = {"None", "Uniform", "Checks", "HalfDark", "Black", "Faint"};
    constexpr const char* dusts[] = {"None", "Uniform", "Grains", "Clean", "Faint"};
    return out << "{" << l.x << ", " << l.y << ", " << l.z << ", " << l.yaw << ", " << l.pitch << ", " << l.width
               << ", " << l.height << ", " << l.near << ", " << l.strength
               << ", Slide::" << slides[static_cast<int>(l.slide)] << ", Dust::" << dusts[static_cast<int>(l.dust)]
               << ", " << l.shadow << ", " << l.clipped << "}";
}

std::ostream& operator<<(std::ostream& out, const BoxRecipe& b) {
    return out << "{" << b.x << ", " << b.y << ", " << b.z << ", " << b.width << ", " << b.height << ", " << b.depth
               << ", " << b.yaw << "}";
}

template <class T>
void list(std::ostream& out, const std::vector<T>& all) {
    out << "{";
    for (const T& one : all) out << (&one == all.data() ? "" : ", ") << one;
    out << "}";
}

}  // namespace

// As C++ code, to be pasted into a test.
std::ostream& operator<<(std::ostream& out, const Recipe& r) {
    out << "Recipe{";
    list(out, r.lights);
    out << ", ";
    list(out, r.boxes);
    return out << ", " << r.floor << ", " << r.wall << ", " << r.eyeX << ", " << r.eyeY << ", " << r.eyeZ << ", "
               << r.yaw << ", " << r.pitch << ", " << r.fov << ", " << r.orthographic << ", " << r.adaptive << ", "
               << r.quads << ", " << r.slices << ", " << r.columns << ", " << r.rows << "}";
}

}  // namespace tyndall::test
