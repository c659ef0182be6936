#include "program.h"

#include <OpenImageIO/imageio.h>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include "glb.h"

namespace tyndall::test {
namespace {

constexpr const char* lavapipe = "/usr/share/vulkan/icd.d/lvp_icd.x86_64.json";

std::string contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string userCacheFolder() {
    if (const char* const cache = std::getenv("XDG_CACHE_HOME")) return cache;
    const char* const home = std::getenv("HOME");
    return home ? std::string(home) + "/.cache" : std::string();
}

struct Running {
    pid_t child;
    std::string out, err;
};

Running start(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    // The user's cache is not used. Mesa keeps using its own cache, else every start takes longer.
    static const std::string cache = freshPath("cache");
    static const std::string mesa = userCacheFolder();
    Running running{-1, freshPath("out.txt"), freshPath("err.txt")};
    running.child = fork();
    if (running.child != 0) return running;
    for (const auto& [path, stream] : {std::pair(&running.out, STDOUT_FILENO), std::pair(&running.err, STDERR_FILENO)})
        dup2(open(path->c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), stream);
    for (const int each : {SIGINT, SIGTERM}) std::signal(each, SIG_DFL);  // the test's parent may ignore them
    // Tests always draw on lavapipe.
    for (const char* const driver : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) setenv(driver, lavapipe, 1);
    setenv("MESA_SHADER_CACHE_DIR", mesa.c_str(), 0);
    setenv("XDG_CACHE_HOME", cache.c_str(), 1);
    for (const std::string& setting : environment) {
        const std::size_t equals = setting.find('=');
        setenv(setting.substr(0, equals).c_str(), setting.substr(equals + 1).c_str(), 1);
    }
    std::vector<char*> argv = {const_cast<char*>(TYNDALL_PROGRAM)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    execv(TYNDALL_PROGRAM, argv.data());
    _exit(127);
}

/// Asks `poll` every few milliseconds until the program has ended; kills it after two minutes.
ProgramRun finish(const Running& running, const std::function<void()>& poll) {
    int status = 0;
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (waitpid(running.child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > deadline) {
            kill(running.child, SIGKILL);
            waitpid(running.child, &status, 0);
            break;
        }
        poll();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(running.out),
            contents(running.err)};
}

/// Linux lists caught signals as a bit mask, signal 1 in the lowest bit (proc(5), /proc/pid/status).
bool catches(pid_t process, int signal) {
    const std::string status = contents("/proc/" + std::to_string(process) + "/status");
    const std::size_t at = status.find("SigCgt:");
    if (at == std::string::npos) return false;
    return (std::stoull(status.substr(at + 7), nullptr, 16) >> (signal - 1) & 1) != 0;
}

}  // namespace

ProgramRun runTyndall(const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    return finish(start(arguments, environment), [] {});
}

ProgramRun interruptTyndall(const std::vector<std::string>& arguments, int signal) {
    const Running running = start(arguments, {});
    bool sent = false;
    return finish(running, [&] {
        if (sent || !catches(running.child, signal)) return;
        kill(running.child, signal);
        sent = true;
    });
}

Pixels readPixels(const std::string& path) {
    Pixels pixels;
    auto file = OIIO::ImageInput::open(path);
    if (!file) return pixels;
    pixels.width = file->spec().width;
    pixels.height = file->spec().height;
    pixels.channels = file->spec().nchannels;
    pixels.values.resize(static_cast<std::size_t>(pixels.width * pixels.height * pixels.channels));
    if (!file->read_image(0, 0, 0, pixels.channels, OIIO::TypeDesc::FLOAT, pixels.values.data())) return {};
    return pixels;
}

std::vector<std::string> neighbours(const std::string& path) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()))
        names.push_back(entry.path().filename().string());
    return names;
}

}  // namespace tyndall::test
