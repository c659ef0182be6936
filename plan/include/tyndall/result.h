// Errors of tyndall's libraries: the one type that permgen's libraries use as well.
#pragma once

#include <permgen/error.h>

namespace tyndall {

using permgen::Error;
using permgen::ErrorCode;
using permgen::Result;

}  // namespace tyndall
