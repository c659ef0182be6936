#pragma once

#include <permgen/tables.h>

/// slices::effect as another translation unit sees it.
const permgen::Effect* elsewhere();
