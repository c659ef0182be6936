// A generated header can be read at compile time, and is one object in all translation units.
#include "header_test.h"

#include <gtest/gtest.h>
#include <slices.fx.h>

namespace {

constexpr const permgen::Technique* plain =
    permgen::find_technique(slices::effect, "clip_nonoise_noshadow_nocookie_technique");
constexpr const permgen::Technique* full =
    permgen::find_technique(slices::effect, "clip_noise_shadow_cookie_technique");

static_assert(slices::effect.name == "slices");
static_assert(slices::effect.techniques.size() == 16);
static_assert(slices::effect.modules.size() == 2);
static_assert(!permgen::find_technique(slices::effect, "none"));
static_assert(plain->passes[0].pixel.module == full->passes[0].pixel.module);
static_assert(plain->passes[0].pixel.module->axes.size() == 4);
static_assert(plain->passes[0].pixel.constants[2].bits == 0 && full->passes[0].pixel.constants[2].bits == 1);
static_assert(permgen::is_live(plain->passes[0], "Globals") && permgen::is_live(full->passes[0], "Globals"));
static_assert(!permgen::is_live(plain->passes[0], "CookieSampler"));
static_assert(permgen::is_live(full->passes[0], "CookieSampler"));
static_assert(permgen::find_state(plain->passes[0], permgen::StateId::DestBlend)->value == "ONE");
static_assert(permgen::find_state(plain->passes[0], permgen::StateId::DestBlend)->bits ==
              static_cast<std::uint32_t>(permgen::Blend::One));
static_assert(!permgen::find_state(plain->passes[0], permgen::StateId::FogEnable));
static_assert(permgen::find_member(slices::effect, "gClipPlanes")->size == 8 * 16);
static_assert(permgen::find_resource(slices::effect, "Globals")->size >= 8 * 16 + 2 * 64);
static_assert(permgen::find_resource(slices::effect, "ShadowMapSampler")->dimension == permgen::ImageDimension::Two);
static_assert(full->passes[0].pixel.module->code[0] == 0x07230203u);
static_assert(full->passes[0].pixel.frozen[0] == 0x07230203u);
static_assert(plain->passes[0].pixel.frozen.size() < full->passes[0].pixel.frozen.size());

TEST(Header, IsOneObjectInTwoTranslationUnits) {
    EXPECT_EQ(&slices::effect, elsewhere());
}

}  // namespace
