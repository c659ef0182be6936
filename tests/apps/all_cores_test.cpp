// The program's parallel loop: every job runs once, and a job's exception is rethrown.
#include <gtest/gtest.h>
#include <tyndall/frame/all_cores.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace tyndall::app {
namespace {

TEST(AllCores, EveryJobRunsOnceBeforeItReturns) {
    for (const std::size_t count : {0, 1, 2, 7, 1000}) {
        std::vector<std::atomic<int>> calls(count);
        onAllCores(count, [&](std::size_t i) { ++calls.at(i); });
        for (const auto& each : calls) EXPECT_EQ(each, 1);
    }
}

TEST(AllCores, WhatAJobThrowsComesBackOnceAllHaveEnded) {
    std::atomic<int> running = 0;
    const auto job = [&](std::size_t i) {
        ++running;
        if (i == 3) {
            --running;
            throw std::runtime_error("three");
        }
        --running;
    };
    EXPECT_THROW(onAllCores(100, job), std::runtime_error);
    EXPECT_EQ(running, 0);
}

}  // namespace
}  // namespace tyndall::app
