// The maximum memory of this process in RAM.
#pragma once

#include <sys/resource.h>

#include <cstdint>

namespace tyndall::app {

/// Bytes; Linux counts it in KiB.
inline std::uint64_t peakResidentBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace tyndall::app
