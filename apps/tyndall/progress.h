// Shows the progress of long work in the terminal, and stops it on a signal.
#pragma once

#include <chrono>
#include <functional>
#include <string>

namespace tyndall::app {

/// Called with the share done, 0 to 1; returning false stops the work.
using Progress = std::function<bool(double)>;

/// From construction to destruction, Ctrl-C and SIGTERM only set a flag that report() reads; a second signal
/// ends the program at once. Ignored signals stay ignored. Only one Watch may exist at a time.
class Watch {
public:
    explicit Watch(std::string what);
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch();

    /// False after a signal. If standard error is a terminal, updates one line on it.
    bool report(double share);

private:
    void clearLine();

    std::string what_;
    bool terminal_, shown_ = false;
    std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace tyndall::app
