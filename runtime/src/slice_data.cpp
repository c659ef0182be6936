// That SliceConstants and SliceVertex lie in memory as slices.fx reads them, asserted at compile time
// against what permgen reflected.
#include <tyndall/slice_data.h>

#include <cstddef>

#include "effects.h"
#include "member_check.h"

namespace tyndall {

#define TYNDALL_CHECK(field, name, bytes)                                                          \
    static_assert(memberIs(effects::slices::effect, name, offsetof(SliceConstants, field), bytes), \
                  "slices.fx moved " name)

TYNDALL_CHECK(clipFromView, "gClipFromView", 64);
TYNDALL_CHECK(lightFromView, "gLightFromView", 64);
TYNDALL_CHECK(boundsMin, "gBoundsMin", 16);
TYNDALL_CHECK(boundsMax, "gBoundsMax", 16);
TYNDALL_CHECK(clipPlanes, "gClipPlanes", 128);
TYNDALL_CHECK(cookieScale, "gCookieScale", 16);
TYNDALL_CHECK(attenuation, "gAttenuation", 16);
TYNDALL_CHECK(dust, "gDust", 16);
TYNDALL_CHECK(noise1, "gNoise1", 16);
TYNDALL_CHECK(noise2, "gNoise2", 16);
TYNDALL_CHECK(colour, "gColour", 16);
TYNDALL_CHECK(weight, "gWeight", 16);
TYNDALL_CHECK(shadow, "gShadow", 16);

#undef TYNDALL_CHECK

static_assert(effects::slices::effect.members.size() == 13, "slices.fx has constants that SliceConstants lacks");
static_assert(blockIs(effects::slices::effect, sizeof(SliceConstants)),
              "slices.fx's block is not SliceConstants' size");

}  // namespace tyndall
