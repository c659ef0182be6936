// The number of calls of operator new, in programs that link allocations.cpp.
#pragma once

#include <cstddef>

namespace tyndall::test {

std::size_t allocations();

}  // namespace tyndall::test
