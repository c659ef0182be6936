#include <study/reference.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "check_scene.h"
#include "pixel.h"

namespace tyndall::study {
namespace {

constexpr auto progressEvery = std::chrono::milliseconds(100);

/// Distributes rows to threads; the calling thread waits and reports.
class Rows {
public:
    /// Computes one row; it should end early once its token requests a stop.
    using Work = std::function<void(int row, const std::atomic<bool>& stop)>;

    Rows(int count, unsigned threads, const Work& work) : count_(count), work_(work) {
        for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
    }

    /// False if `progress` stopped the work. Rethrows an exception of a row.
    bool wait(const std::function<bool(double)>& progress) {
        bool wanted = true;
        {
            std::unique_lock lock(mutex_);
            while (finished_ < threads_.size()) {
                changed_.wait_for(lock, progressEvery);
                lock.unlock();
                if (wanted && progress && !progress(static_cast<double>(done_.load()) / count_)) {
                    wanted = false;
                    stop_ = true;
                }
                lock.lock();
            }
        }
        threads_.clear();
        if (thrown_) std::rethrow_exception(thrown_);
        return wanted;
    }

private:
    void run() {
        try {
            for (int row = next_++; row < count_ && !stop_; row = next_++) {
                work_(row, stop_);
                ++done_;
            }
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            thrown_ = std::current_exception();
            stop_ = true;
        }
        const std::scoped_lock lock(mutex_);
        ++finished_;
        changed_.notify_one();
    }

    int count_;
    const Work& work_;
    std::atomic<int> next_ = 0, done_ = 0;
    std::atomic<bool> stop_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t finished_ = 0;
    std::exception_ptr thrown_;
    std::vector<std::jthread> threads_;  // last: they use the other members
};

}  // namespace

Result<ReferenceImage> reference(const ReferenceScene& scene, const ReferenceOptions& options) {
    if (auto checked = checkScene(scene, options); !checked) return tl::unexpected(checked.error());
    const PreparedScene prepared = prepare(scene);

    ReferenceImage image;
    image.width = scene.width;
    image.height = scene.height;
    image.radiance.resize(static_cast<std::size_t>(scene.width) * scene.height);
    image.bound.resize(image.radiance.size());
    std::vector<std::uint64_t> evaluations(static_cast<std::size_t>(scene.height));
    const Rows::Work row = [&](int y, const std::atomic<bool>& stop) {
        for (int x = 0; x < scene.width && !stop; ++x) {
            const Pixel pixel = integratePixel(prepared, x, y, options.accuracy);
            const std::size_t at = static_cast<std::size_t>(y) * scene.width + x;
            image.radiance[at] = pixel.radiance;
            for (int c = 0; c < 3; ++c)
                if (pixel.radiance[c] > 0.0)
                    image.bound[at] = std::max(image.bound[at], pixel.error[c] / pixel.radiance[c]);
            evaluations[static_cast<std::size_t>(y)] += pixel.evaluations;
        }
    };
    const unsigned processors = std::max(1u, std::thread::hardware_concurrency());
    Rows rows(scene.height,
              std::min(options.threads > 0 ? options.threads : processors, static_cast<unsigned>(scene.height)), row);
    if (!rows.wait(options.progress)) return tl::unexpected(Error{ErrorCode::Interrupted, "interrupted"});

    image.largestBound = *std::max_element(image.bound.begin(), image.bound.end());
    for (const std::uint64_t count : evaluations) image.evaluations += count;
    return image;
}

}  // namespace tyndall::study
