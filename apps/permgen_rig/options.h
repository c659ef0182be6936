// The command line.
#pragma once

#include <string>

namespace tyndall::rig {

struct Options {
    std::string manifest, fixture;
    std::string goldens, report;  ///< folders; empty: none
    std::string technique;        ///< empty: all
    std::string device;           ///< part of a name; empty: lavapipe before a GPU
    bool updateGoldens = false;
    bool list = false;
};

/// Exit status if there is nothing to run: 0 after --help or --version, 2 if the command line is wrong; else -1.
int parseOptions(int argc, char** argv, Options& options);

}  // namespace tyndall::rig
