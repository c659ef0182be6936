// How a caller lends its threads: the library makes none of its own.
#pragma once

#include <cstddef>
#include <functional>

namespace tyndall {

/// Calls job(0) to job(count - 1), each once, in any order and on any threads, and returns when all calls have
/// returned. Its own exceptions, and those of a job (out of memory), may leave it; by then no job may be running.
using ParallelFor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

}  // namespace tyndall
