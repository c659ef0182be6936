// Runs work that may crash, hang or exhaust memory in forked children of this process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace permgen {

struct WorkerLimits {
    std::chrono::milliseconds wall{20'000};
    std::uint64_t memory = std::uint64_t{2} << 30;  ///< bytes of address space; not enforced under AddressSanitizer
};

enum class WorkerEnd {
    Done,         ///< `reply` is complete
    Crashed,      ///< a signal ended it: `detail` is the signal
    TimedOut,     ///< it ran past WorkerLimits::wall and was killed
    OutOfMemory,  ///< it asked for more than WorkerLimits::memory
    Failed,       ///< it ended without an answer: `detail` is its exit status
    NotStarted,   ///< no process or pipe was available: `detail` is errno
};

struct WorkerResult {
    WorkerEnd end = WorkerEnd::NotStarted;
    int detail = 0;
    std::string reply;
};

/// Runs task(0) … task(count - 1), each in its own child, at most `jobs` at a time, and returns their results in the
/// order of the tasks. Changes that a task makes in memory stay in its child; its output is dropped. All children have
/// ended when this returns. Other threads of the calling process must not hold locks that a task needs.
std::vector<WorkerResult> run_workers(std::size_t count, int jobs, const WorkerLimits& limits,
                                      const std::function<std::string(std::size_t)>& task);

/// "crashed (Segmentation fault)" and so on, completes a sentence that begins with the name of the work; empty for
/// Done.
std::string describe_failure(const WorkerResult& result, const WorkerLimits& limits);

/// The number of processors this process may use, at least 1.
int default_jobs();

}  // namespace permgen
