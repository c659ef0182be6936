#include "back/worker.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <thread>

namespace permgen {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int exit_out_of_memory = 86;
constexpr int exit_exception = 87;
constexpr std::size_t frame_header = sizeof(std::uint64_t);  // length of the reply, then the reply

#if defined(__SANITIZE_ADDRESS__)
constexpr bool address_space_is_ours = false;  // AddressSanitizer reserves terabytes for its shadow
#else
constexpr bool address_space_is_ours = true;
#endif

/// A running child. Its destructor kills it and waits for it.
struct Child {
    Child() = default;
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        ::close(pipe);
        if (pid > 0) {
            ::kill(pid, SIGKILL);
            while (::waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
            }
        }
    }

    std::size_t index = 0;
    pid_t pid = 0;
    int pipe = -1;
    Clock::time_point deadline;
    std::string received;
};

bool write_all(int file, const char* data, std::size_t size) {
    while (size > 0) {
        const ssize_t written = ::write(file, data, size);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return false;
        data += written;
        size -= static_cast<std::size_t>(written);
    }
    return true;
}

void limit(decltype(RLIMIT_AS) resource, rlim_t value) {
    rlimit current{};
    if (::getrlimit(resource, &current) != 0) return;
    current.rlim_cur = std::min<rlim_t>(value, current.rlim_max);
    ::setrlimit(resource, &current);
}

void prepare_child(const WorkerLimits& limits, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) ::_exit(exit_exception);
    // A sanitizer or a host program may have handlers; the worker must crash without them.
    for (const int fatal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGINT}) ::signal(fatal, SIG_DFL);
    ::signal(SIGPIPE, SIG_IGN);
    limit(RLIMIT_CORE, 0);
    if (address_space_is_ours) limit(RLIMIT_AS, limits.memory);
    std::set_new_handler([] { ::_exit(exit_out_of_memory); });
    const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    if (nowhere >= 0) {
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
    }
}

[[noreturn]] void run_child(int pipe, const WorkerLimits& limits, pid_t parent, std::size_t index,
                            const std::function<std::string(std::size_t)>& task) {
    prepare_child(limits, parent);
    int status = exit_exception;
    try {
        const std::string reply = task(index);
        const std::uint64_t length = reply.size();
        char header[frame_header];
        std::memcpy(header, &length, frame_header);
        if (write_all(pipe, header, frame_header) && write_all(pipe, reply.data(), reply.size())) status = 0;
    } catch (const std::bad_alloc&) {
        status = exit_out_of_memory;
    } catch (...) {
    }
    ::_exit(status);  // no destructors: they belong to the parent
}

/// Empty, with `error` = errno, if no process or pipe is available.
std::unique_ptr<Child> start(std::size_t index, const WorkerLimits& limits,
                             const std::function<std::string(std::size_t)>& task, int& error) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) {
        error = errno;
        return nullptr;
    }
    const pid_t parent = ::getpid();
    const pid_t pid = ::fork();
    if (pid == 0) {
        ::close(ends[0]);
        run_child(ends[1], limits, parent, index, task);
    }
    error = errno;
    ::close(ends[1]);
    if (pid < 0) {
        ::close(ends[0]);
        return nullptr;
    }
    auto child = std::make_unique<Child>();
    child->index = index;
    child->pid = pid;
    child->pipe = ends[0];
    child->deadline = Clock::now() + limits.wall;
    return child;
}

std::optional<std::string> whole_reply(const std::string& received) {
    if (received.size() < frame_header) return std::nullopt;
    std::uint64_t length = 0;
    std::memcpy(&length, received.data(), frame_header);
    if (received.size() - frame_header != length) return std::nullopt;
    return received.substr(frame_header);
}

/// Waits for a child that has closed its pipe; kills it after its deadline.
WorkerResult reap(Child& child) {
    int status = 0;
    bool timed_out = false;
    for (;;) {
        const pid_t ended = ::waitpid(child.pid, &status, timed_out ? 0 : WNOHANG);
        if (ended == child.pid) break;
        if (ended < 0 && errno == EINTR) continue;
        if (ended < 0) {  // ECHILD: the parent process ignores SIGCHLD, so the status is lost
            status = 0;
            break;
        }
        if (Clock::now() >= child.deadline) {
            ::kill(child.pid, SIGKILL);
            timed_out = true;
        } else {
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        }
    }
    child.pid = 0;
    if (auto reply = whole_reply(child.received)) return {WorkerEnd::Done, 0, std::move(*reply)};
    if (timed_out) return {WorkerEnd::TimedOut, 0, {}};
    if (WIFSIGNALED(status)) return {WorkerEnd::Crashed, WTERMSIG(status), {}};
    if (WEXITSTATUS(status) == exit_out_of_memory) return {WorkerEnd::OutOfMemory, 0, {}};
    return {WorkerEnd::Failed, WEXITSTATUS(status), {}};
}

/// True at the end of the child's output.
bool drain(Child& child) {
    char buffer[65536];
    const ssize_t got = ::read(child.pipe, buffer, sizeof buffer);
    if (got < 0) return errno != EINTR && errno != EAGAIN;
    child.received.append(buffer, static_cast<std::size_t>(got));
    return got == 0;
}

void wait_for_news(const std::vector<std::unique_ptr<Child>>& running, std::vector<pollfd>& polled) {
    polled.clear();
    Clock::time_point deadline = Clock::time_point::max();
    for (const auto& child : running) {
        polled.push_back({child->pipe, POLLIN, 0});
        deadline = std::min(deadline, child->deadline);
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    constexpr decltype(left) longest = 60'000;
    // A signal interrupts poll() and leaves every revents 0: check the deadlines, then poll again.
    ::poll(polled.data(), polled.size(), static_cast<int>(std::clamp<decltype(left)>(left, 0, longest)));
}

}  // namespace

std::vector<WorkerResult> run_workers(std::size_t count, int jobs, const WorkerLimits& limits,
                                      const std::function<std::string(std::size_t)>& task) {
    std::vector<WorkerResult> results(count);
    std::vector<std::unique_ptr<Child>> running;
    std::vector<pollfd> polled;
    const std::size_t max_running = static_cast<std::size_t>(std::max(jobs, 1));
    std::size_t next = 0;
    while (next < count || !running.empty()) {
        while (next < count && running.size() < max_running) {
            int error = 0;
            if (auto child = start(next, limits, task, error)) {
                running.push_back(std::move(child));
            } else if (!running.empty()) {
                break;  // out of processes or files: try again after a child has ended
            } else {
                results[next] = {WorkerEnd::NotStarted, error, {}};
            }
            ++next;
        }
        if (running.empty()) continue;
        wait_for_news(running, polled);
        for (std::size_t i = running.size(); i-- > 0;) {
            Child& child = *running[i];
            const bool ended = polled[i].revents != 0 && drain(child);
            if (ended) {
                results[child.index] = reap(child);
            } else if (Clock::now() >= child.deadline) {
                results[child.index] = {WorkerEnd::TimedOut, 0, {}};
            } else {
                continue;
            }
            running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
        }
    }
    return results;
}

std::string describe_failure(const WorkerResult& result, const WorkerLimits& limits) {
    switch (result.end) {
        case WorkerEnd::Done:
            return {};
        case WorkerEnd::Crashed:
            if (result.detail == SIGKILL) return "was killed from outside (most likely the system ran out of memory)";
            return std::string("crashed (") + ::strsignal(result.detail) + ")";
        case WorkerEnd::TimedOut: {
            const auto ms = limits.wall.count();
            return "did not finish within " +
                   (ms % 1000 ? std::to_string(ms) + " ms" : std::to_string(ms / 1000) + " s");
        }
        case WorkerEnd::OutOfMemory:
            return "needed more than " + std::to_string(limits.memory >> 20) + " MiB of memory";
        case WorkerEnd::Failed:
            return "ended without an answer (status " + std::to_string(result.detail) + ")";
        case WorkerEnd::NotStarted:
            return std::string("could not be started (") + std::strerror(result.detail) + ")";
    }
    return {};
}

int default_jobs() {
    cpu_set_t processors;
    if (::sched_getaffinity(0, sizeof processors, &processors) == 0) return std::max(CPU_COUNT(&processors), 1);
    return static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
}

}  // namespace permgen
