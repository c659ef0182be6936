// Errors are the runtime's: values with one sentence and, if a call failed, Vulkan's result.
#pragma once

#include <tyndall/result.h>

namespace headless {

using tyndall::Error;
using tyndall::ErrorCode;
using tyndall::Result;

}  // namespace headless
