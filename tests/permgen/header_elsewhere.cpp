#include <slices.fx.h>

#include "header_test.h"

const permgen::Effect* elsewhere() {
    return &slices::effect;
}
