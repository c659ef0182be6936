// This program's threads, for libraries that make none.
#pragma once

#include <cstddef>
#include <functional>

namespace tyndall::app {

/// A tyndall::ParallelFor over as many threads as there are cores, this one included. Where the system gives fewer
/// threads, those do all the work. Of exceptions that jobs throw the first comes back, once all threads have ended.
void onAllCores(std::size_t count, const std::function<void(std::size_t)>& job);

}  // namespace tyndall::app
