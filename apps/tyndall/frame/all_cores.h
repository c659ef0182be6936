// A parallel loop for libraries that create no threads.
#pragma once

#include <cstddef>
#include <functional>

namespace tyndall::app {

/// A tyndall::ParallelFor with one thread per core, the calling thread included. If the system gives fewer threads,
/// those do all the work. The first exception of a job is rethrown after all threads have ended.
void onAllCores(std::size_t count, const std::function<void(std::size_t)>& job);

}  // namespace tyndall::app
