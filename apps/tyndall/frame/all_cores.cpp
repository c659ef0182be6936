#include "all_cores.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace tyndall::app {

void onAllCores(std::size_t count, const std::function<void(std::size_t)>& job) {
    std::atomic<std::size_t> next = 0;
    std::mutex failing;
    std::exception_ptr failed;
    const auto work = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) job(i);
        } catch (...) {
            const std::lock_guard lock(failing);
            if (!failed) failed = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> helpers;
        const std::size_t threads = std::min<std::size_t>(count, std::thread::hardware_concurrency());
        try {
            for (std::size_t i = 1; i < threads; ++i) helpers.emplace_back(work);
        } catch (const std::system_error&) {
        }
        work();
    }
    if (failed) std::rethrow_exception(failed);
}

}  // namespace tyndall::app
