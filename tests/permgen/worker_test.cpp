#include "back/worker.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <thread>

namespace permgen {
namespace {

using namespace std::chrono_literals;

std::size_t open_files() {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator("/proc/self/fd"), std::filesystem::directory_iterator()));
}

/// Every test checks that no child process and no open file is left.
class Worker : public testing::Test {
protected:
    void SetUp() override { files_ = open_files(); }
    void TearDown() override {
        EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
        EXPECT_EQ(errno, ECHILD);
        EXPECT_EQ(open_files(), files_) << "a file is left open";
    }

private:
    std::size_t files_ = 0;
};

std::string numbered(std::size_t i) {
    return "reply " + std::to_string(i);
}

TEST_F(Worker, ResultsKeepTheirOrderWhateverOrderTheyEndIn) {
    for (const int jobs : {1, 2, 8}) {
        const auto results = run_workers(6, jobs, {}, [](std::size_t i) {
            std::this_thread::sleep_for((6 - i) * 5ms);
            return numbered(i);
        });
        ASSERT_EQ(results.size(), 6u);
        for (std::size_t i = 0; i < results.size(); ++i) {
            EXPECT_EQ(results[i].end, WorkerEnd::Done);
            EXPECT_EQ(results[i].reply, numbered(i)) << "jobs " << jobs;
        }
    }
}

TEST_F(Worker, NothingToDo) {
    EXPECT_TRUE(run_workers(0, 4, {}, numbered).empty());
}

TEST_F(Worker, RepliesMayBeEmptyOrLargerThanAPipe) {
    const auto size = [](std::size_t i) { return i * (std::size_t{3} << 20); };
    const auto results =
        run_workers(3, 3, {}, [&](std::size_t i) { return std::string(size(i), static_cast<char>('a' + i)); });
    for (std::size_t i = 0; i < results.size(); ++i) {
        EXPECT_EQ(results[i].end, WorkerEnd::Done);
        EXPECT_EQ(results[i].reply, std::string(size(i), static_cast<char>('a' + i)));
    }
}

TEST_F(Worker, ACrashIsReportedAndTheOthersFinish) {
    const auto results = run_workers(4, 2, {}, [](std::size_t i) {
        if (i == 1) std::raise(SIGSEGV);
        return numbered(i);
    });
    EXPECT_EQ(results[1].end, WorkerEnd::Crashed);
    EXPECT_EQ(results[1].detail, SIGSEGV);
    EXPECT_NE(describe_failure(results[1], {}).find("crashed (Segmentation fault"), std::string::npos);
    for (const std::size_t i : {0, 2, 3}) EXPECT_EQ(results[i].reply, numbered(i));
}

TEST_F(Worker, AHangIsEndedAndTheOthersFinish) {
    const WorkerLimits limits{200ms, WorkerLimits{}.memory};
    const auto before = std::chrono::steady_clock::now();
    const auto results = run_workers(3, 2, limits, [](std::size_t i) {
        while (i == 0) std::this_thread::sleep_for(1s);
        return numbered(i);
    });
    EXPECT_EQ(results[0].end, WorkerEnd::TimedOut);
    EXPECT_EQ(describe_failure(results[0], limits), "did not finish within 200 ms");
    EXPECT_EQ(results[1].reply, numbered(1));
    EXPECT_EQ(results[2].reply, numbered(2));
    EXPECT_LT(std::chrono::steady_clock::now() - before, 10s);
}

TEST_F(Worker, AChildThatClosesItsPipeAndHangsIsEnded) {
    const auto results = run_workers(1, 1, {200ms, WorkerLimits{}.memory}, [](std::size_t) -> std::string {
        for (int file = 3; file < 64; ++file) ::close(file);
        for (;;) std::this_thread::sleep_for(1s);
    });
    EXPECT_EQ(results[0].end, WorkerEnd::TimedOut);
}

TEST_F(Worker, MemoryIsLimited) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "AddressSanitizer's shadow does not fit under a limit of address space";
#endif
    const WorkerLimits limits{20s, std::uint64_t{256} << 20};
    const auto results = run_workers(2, 2, limits, [](std::size_t i) {
        std::string text = numbered(i);
        while (i == 0) text += text;
        return text;
    });
    EXPECT_EQ(results[0].end, WorkerEnd::OutOfMemory);
    EXPECT_EQ(describe_failure(results[0], limits), "needed more than 256 MiB of memory");
    EXPECT_EQ(results[1].reply, numbered(1));
}

TEST_F(Worker, AnExitWithoutAnAnswerIsAFailure) {
    const auto results = run_workers(1, 1, {}, [](std::size_t) -> std::string { ::_exit(0); });
    EXPECT_EQ(results[0].end, WorkerEnd::Failed);
    EXPECT_EQ(describe_failure(results[0], {}), "ended without an answer (status 0)");
}

TEST_F(Worker, AnExceptionIsAFailure) {
    const auto results = run_workers(1, 1, {}, [](std::size_t) -> std::string { throw 1; });
    EXPECT_EQ(results[0].end, WorkerEnd::Failed);
}

TEST_F(Worker, AKillFromOutsideIsReported) {
    const auto results = run_workers(1, 1, {}, [](std::size_t) -> std::string {
        ::kill(::getpid(), SIGKILL);
        return {};
    });
    EXPECT_EQ(results[0].end, WorkerEnd::Crashed);
    EXPECT_NE(describe_failure(results[0], {}).find("killed from outside"), std::string::npos);
}

TEST_F(Worker, AReplyCutOffHalfwayIsNotTaken) {
    // Much more than a pipe transfers in the first worker's 5 ms.
    constexpr std::size_t long_reply = std::size_t{128} << 20;
    const auto results = run_workers(2, 1, {}, [](std::size_t i) {
        std::string reply(i == 0 ? long_reply : 1000, 'x');
        const itimerval soon{{0, 0}, {0, 5000}};
        if (i == 0) ::setitimer(ITIMER_REAL, &soon, nullptr);
        return reply;
    });
    EXPECT_NE(results[0].end, WorkerEnd::Done);
    EXPECT_TRUE(results[0].reply.empty());
    EXPECT_EQ(results[1].end, WorkerEnd::Done);
}

TEST_F(Worker, SignalsDoNotDisturb) {
    struct sigaction action {};
    struct sigaction before {};
    action.sa_handler = [](int) {};  // without SA_RESTART: every system call may end with EINTR
    ::sigaction(SIGALRM, &action, &before);
    const itimerval often{{0, 500}, {0, 500}};
    ::setitimer(ITIMER_REAL, &often, nullptr);
    const auto results = run_workers(8, 4, {}, [](std::size_t i) {
        std::this_thread::sleep_for(5ms);
        return std::string(std::size_t{1} << 20, static_cast<char>('a' + i));
    });
    const itimerval never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
    ::sigaction(SIGALRM, &before, nullptr);
    for (std::size_t i = 0; i < results.size(); ++i)
        EXPECT_EQ(results[i].reply, std::string(std::size_t{1} << 20, static_cast<char>('a' + i)));
}

TEST_F(Worker, WorksWhereSomebodyIgnoresChildren) {
    const auto before = std::signal(SIGCHLD, SIG_IGN);
    const auto results = run_workers(3, 2, {}, [](std::size_t i) {
        if (i == 1) std::raise(SIGSEGV);
        return numbered(i);
    });
    std::signal(SIGCHLD, before);
    EXPECT_EQ(results[0].reply, numbered(0));
    EXPECT_EQ(results[1].end, WorkerEnd::Failed);
    EXPECT_EQ(results[2].reply, numbered(2));
}

TEST_F(Worker, SaysWhenNothingCouldBeStarted) {
    rlimit files{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &files), 0);
    rlimit none = files;
    none.rlim_cur = 3;
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
    const auto results = run_workers(2, 2, {}, numbered);
    ::setrlimit(RLIMIT_NOFILE, &files);
    for (const WorkerResult& result : results) {
        EXPECT_EQ(result.end, WorkerEnd::NotStarted);
        EXPECT_EQ(describe_failure(result, {}), "could not be started (Too many open files)");
    }
}

TEST_F(Worker, GetsByWithFewFiles) {
    rlimit files{};
    ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &files), 0);
    rlimit few = files;
    few.rlim_cur = open_files() + 3;  // room for one or two pipes at a time
    ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
    const auto results = run_workers(8, 8, {}, [](std::size_t i) {
        std::this_thread::sleep_for(2ms);
        return numbered(i);
    });
    ::setrlimit(RLIMIT_NOFILE, &files);
    for (std::size_t i = 0; i < results.size(); ++i) EXPECT_EQ(results[i].reply, numbered(i));
}

}  // namespace
}  // namespace permgen
