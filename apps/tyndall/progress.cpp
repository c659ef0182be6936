#include "progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

namespace tyndall::app {
namespace {

volatile std::sig_atomic_t stop = 0;

void askToStop(int) {
    stop = 1;
}

constexpr std::array signals{SIGINT, SIGTERM};
std::array<struct sigaction, signals.size()> before;

void catchSignals() {
    struct sigaction action {};
    action.sa_handler = askToStop;
    action.sa_flags = SA_RESETHAND | SA_RESTART;  // the second signal has the default action: it ends the program
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);  // as nohup and shells expect
    }
}

void releaseSignals() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before[i], nullptr);
}

constexpr auto linesEvery = std::chrono::milliseconds(200);

}  // namespace

Watch::Watch(std::string what)
    : what_(std::move(what)),
      terminal_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {
    stop = 0;
    catchSignals();
}

Watch::~Watch() {
    releaseSignals();
    clearLine();
}

bool Watch::report(double share) {
    if (stop != 0) return false;
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ || now - last_ < linesEvery) return true;
    last_ = now;
    shown_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const std::string left =
        share > 0.01 ? fmt::format(", about {:.0f} s left", seconds * (1.0 - share) / share) : std::string();
    fmt::print(stderr, "\r\x1b[Ktyndall: {} {:.0f} %, {:.0f} s{}", what_, 100.0 * share, seconds, left);
    std::fflush(stderr);
    return true;
}

void Watch::clearLine() {
    if (!shown_) return;
    fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
}

}  // namespace tyndall::app
