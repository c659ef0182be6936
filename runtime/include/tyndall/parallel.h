// A loop that runs on the caller's threads: the library makes no threads.
#pragma once

#include <cstddef>
#include <functional>

namespace tyndall {

/// Calls job(0) to job(count - 1), each once, in any order and on any threads, and returns when all calls have
/// returned. It may throw its own exceptions and those of a job (out of memory), but only after all jobs have ended.
using ParallelFor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& job)>;

}  // namespace tyndall
