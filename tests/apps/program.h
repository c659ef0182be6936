// Runs the real tyndall program.
#pragma once

#include <string>
#include <vector>

namespace tyndall::test {

struct ProgramRun {
    int status = -1;     ///< exit status; 128 + signal if it was killed
    std::string output;  ///< standard output
    std::string errors;  ///< standard error
};

/// Runs it with these arguments on lavapipe, with these "NAME=value" settings on top of the environment.
/// Killed after two minutes.
ProgramRun runTyndall(const std::vector<std::string>& arguments, const std::vector<std::string>& environment = {});

/// The same, but sends `signal` as soon as the program has a handler for it.
ProgramRun interruptTyndall(const std::vector<std::string>& arguments, int signal);

/// The content of an OpenEXR or PNG file: `channels` floats a pixel, rows top to bottom.
struct Pixels {
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;
    float at(int x, int y, int channel) const {
        return values[static_cast<std::size_t>((y * width + x) * channels + channel)];
    }
};
Pixels readPixels(const std::string& path);

/// Names of the files in the folder of `path`.
std::vector<std::string> neighbours(const std::string& path);

}  // namespace tyndall::test
