// How long work is followed from the terminal, and stopped from it.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace tyndall::app {

/// Told the share done, 0 to 1; false asks the work to stop.
using Progress = std::function<bool(double)>;

/// From construction to destruction, Ctrl-C and SIGTERM only set a mark that report() answers to; a second one
/// ends the program at once. Signals that were ignored stay so. One at a time.
class Watch {
public:
    explicit Watch(std::string what);
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch();

    /// False once a signal came. Where standard error is a terminal, keeps one line up to date on it.
    bool report(double share);

private:
    void clearLine();

    std::string what_;
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace tyndall::app
