// Random recipes for rapidcheck: simpler ones have fewer lights and boxes and smaller numbers.
#pragma once

#include <rapidcheck.h>

#include "recipe.h"

namespace tyndall::test {

inline rc::Gen<LightRecipe> lightRecipes() {
    using rc::gen::set;
    return rc::gen::build<LightRecipe>(
        set(&LightRecipe::x, rc::gen::inRange(-30, 31)), set(&LightRecipe::y, rc::gen::inRange(10, 40)),
        set(&LightRecipe::z, rc::gen::inRange(-30, 31)), set(&LightRecipe::yaw, rc::gen::inRange(-180, 181)),
        set(&LightRecipe::pitch, rc::gen::inRange(-90, 20)), set(&LightRecipe::width, rc::gen::inRange(10, 90)),
        set(&LightRecipe::height, rc::gen::inRange(10, 90)), set(&LightRecipe::near, rc::gen::inRange(5, 80)),
        set(&LightRecipe::strength, rc::gen::inRange(-10, 12)),
        set(&LightRecipe::slide,
            rc::gen::element(Slide::None, Slide::Uniform, Slide::Checks, Slide::HalfDark, Slide::Black, Slide::Faint)),
        set(&LightRecipe::dust,
            rc::gen::element(Dust::None, Dust::None, Dust::Uniform, Dust::Grains, Dust::Clean, Dust::Faint)),
        set(&LightRecipe::shadow, rc::gen::arbitrary<bool>()),
        set(&LightRecipe::clipped, rc::gen::map(rc::gen::inRange(0, 4), [](int i) { return i == 3; })));
}

inline rc::Gen<BoxRecipe> boxRecipes() {
    using rc::gen::set;
    return rc::gen::build<BoxRecipe>(
        set(&BoxRecipe::x, rc::gen::inRange(-30, 31)), set(&BoxRecipe::y, rc::gen::inRange(0, 30)),
        set(&BoxRecipe::z, rc::gen::inRange(-30, 31)), set(&BoxRecipe::width, rc::gen::inRange(1, 20)),
        set(&BoxRecipe::height, rc::gen::inRange(1, 20)), set(&BoxRecipe::depth, rc::gen::inRange(0, 20)),
        set(&BoxRecipe::yaw, rc::gen::inRange(0, 90)));
}

template <class T>
rc::Gen<std::vector<T>> upTo(int min, int max, const rc::Gen<T>& one) {
    return rc::gen::suchThat(
        rc::gen::resize(max, rc::gen::container<std::vector<T>>(rc::gen::resize(rc::kNominalSize, one))),
        [=](const auto& all) { return static_cast<int>(all.size()) >= min && static_cast<int>(all.size()) <= max; });
}

inline rc::Gen<Recipe> recipes() {
    using rc::gen::set;
    return rc::gen::resize(
        rc::kNominalSize,
        rc::gen::build<Recipe>(
            set(&Recipe::lights, upTo(1, 4, lightRecipes())), set(&Recipe::boxes, upTo(0, 4, boxRecipes())),
            set(&Recipe::floor, rc::gen::arbitrary<bool>()), set(&Recipe::wall, rc::gen::arbitrary<bool>()),
            set(&Recipe::eyeX, rc::gen::inRange(-38, 39)), set(&Recipe::eyeY, rc::gen::inRange(2, 38)),
            set(&Recipe::eyeZ, rc::gen::inRange(-30, 60)), set(&Recipe::yaw, rc::gen::inRange(-40, 41)),
            set(&Recipe::pitch, rc::gen::inRange(-40, 30)), set(&Recipe::fov, rc::gen::inRange(20, 100)),
            set(&Recipe::orthographic, rc::gen::map(rc::gen::inRange(0, 5), [](int i) { return i == 4; })),
            set(&Recipe::adaptive, rc::gen::arbitrary<bool>()),
            set(&Recipe::quads, rc::gen::map(rc::gen::inRange(0, 4), [](int i) { return i == 3; })),
            set(&Recipe::slices, rc::gen::map(rc::gen::inRange(1, 65), [](int i) { return 4 * i; })),
            set(&Recipe::columns, rc::gen::inRange(1, 10)), set(&Recipe::rows, rc::gen::inRange(1, 8))));
}

}  // namespace tyndall::test
