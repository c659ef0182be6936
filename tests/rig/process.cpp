#include "process.h"

#include <rig/report.h>
#include <sys/wait.h>

#include <cstdio>
#include <stdexcept>

#include "folder.h"

namespace tyndall::test {

Ran runProgram(const std::vector<std::string>& words) {
    FILE* pipe = popen((rig::shellCommand(words) + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("no process can be started");
    Ran ran;
    char buffer[4096];
    while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, pipe)) ran.text.append(buffer, got);
    const int status = pclose(pipe);
    ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ran;
}

std::string compileEffect(const std::string& folder, const std::string& name, const std::string& text,
                          const std::vector<std::string>& options) {
    const std::string source = folder + "/" + name + ".fx";
    writeText(source, text);
    std::vector<std::string> words{PERMGEN, "compile", source, "-o", folder + "/out", "--freeze"};
    words.insert(words.end(), options.begin(), options.end());
    const Ran ran = runProgram(words);
    if (ran.status != 0) throw std::runtime_error(ran.text);
    return folder + "/out/" + name + ".fx.json";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos || text.find(from, at + 1) != std::string::npos)
        throw std::runtime_error("'" + from + "' does not occur just once");
    return text.replace(at, from.size(), to);
}

}  // namespace tyndall::test
