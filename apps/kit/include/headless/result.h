// Errors here are the runtime's: values with one sentence and, where a call failed, Vulkan's own result.
#pragma once

#include <tyndall/result.h>

namespace headless {

using tyndall::Error;
using tyndall::ErrorCode;
using tyndall::Result;

}  // namespace headless
