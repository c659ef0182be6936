// The program: command line in, verdicts out.
#include <common/nearest.h>
#include <fmt/format.h>
#include <permgen/manifest.h>
#include <rig/report.h>

#include <bit>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "checks.h"
#include "effect_renderer.h"
#include "fixture.h"
#include "options.h"

namespace tyndall::rig {
namespace {

enum Status { Passed = 0, Failed = 1, NothingTried = 2 };

struct Failing {
    std::string sentence;
};

[[noreturn]] void stop(const std::string& sentence) {
    throw Failing{sentence};
}

/// The effect with the requested techniques only.
permgen::Effect chosen(const permgen::Effect& effect, const Options& options) {
    if (options.technique.empty()) return effect;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < effect.techniques.size(); ++i) {
        names.push_back(effect.techniques[i].name);
        if (names.back() != options.technique) continue;
        permgen::Effect one = effect;
        one.techniques = effect.techniques.subspan(i, 1);
        return one;
    }
    stop(fmt::format("{}: there is no technique '{}'{}", options.manifest, options.technique,
                     permgen::suggestion(options.technique, names, "; did you mean '", "'?")));
}

void checkFrozen(const permgen::Effect& effect, const Options& options) {
    for (const permgen::Technique& technique : effect.techniques)
        for (const permgen::Pass& pass : technique.passes)
            for (const permgen::Shader* shader : {&pass.vertex, &pass.pixel})
                if (shader->module && shader->frozen.empty())
                    stop(fmt::format("{}: {} has no frozen modules; compile the effect with permgen compile --freeze",
                                     options.manifest, technique.name));
}

/// A fixture has constants and textures, and a picture is what a pass draws.
void checkDrawn(const permgen::Effect& effect, const Options& options) {
    constexpr std::string_view remedy = "; name a technique that draws with --technique";
    for (const permgen::Technique& technique : effect.techniques)
        for (const permgen::Pass& pass : technique.passes) {
            if (pass.compute.module)
                stop(fmt::format("{}: {} computes, and permgen-rig tests what is drawn{}", options.manifest,
                                 technique.name, remedy));
            for (const permgen::Resource* resource : pass.live)
                if (resource->kind == permgen::ResourceKind::StorageBuffer)
                    stop(fmt::format("{}: {} reads the storage buffer {}, and a fixture has none{}", options.manifest,
                                     technique.name, resource->name, remedy));
        }
}

headless::Device openDevice(const Options& options) {
    headless::DeviceOptions wanted;
    wanted.deviceName = options.device;
    wanted.preferSoftware = true;
    wanted.validation = true;
    wanted.skipInvalidCalls = true;  // a driver may crash on invalid calls
    auto device = headless::Device::create(wanted);
    if (device) return std::move(*device);
    const std::string reason = device.error().message;
    wanted.validation = false;
    auto silent = headless::Device::create(wanted);
    if (!silent) stop("no device to draw on: " + silent.error().message);
    fmt::print("note: drawing without validation: {}\n", reason);
    return std::move(*silent);
}

std::string valueOf(const permgen::Constant& constant) {
    switch (constant.type) {
        case permgen::ScalarType::Bool:
            return constant.bits != 0 ? "true" : "false";
        case permgen::ScalarType::Int:
            return std::to_string(std::bit_cast<std::int32_t>(constant.bits));
        case permgen::ScalarType::Uint:
            return std::to_string(constant.bits);
        case permgen::ScalarType::Float:
            return fmt::format("{}", std::bit_cast<float>(constant.bits));
    }
    return {};
}

/// The switches of one pass, or of all of them with the passes' names.
std::vector<std::pair<std::string, std::string>> switches(const permgen::Technique& technique,
                                                          const std::string& pass) {
    std::vector<std::pair<std::string, std::string>> named;
    for (std::size_t i = 0; i < technique.passes.size(); ++i) {
        const std::string label = passLabel(technique, i);
        if (!pass.empty() && pass != label) continue;
        for (const permgen::Shader* shader : {&technique.passes[i].vertex, &technique.passes[i].pixel})
            for (const permgen::Constant& constant : shader->constants)
                named.emplace_back((pass.empty() ? label + "." : "") + std::string(constant.name), valueOf(constant));
    }
    return named;
}

/// An absolute path, so that the command works in any folder.
std::string absolute(const std::string& path) {
    std::error_code ignored;
    return path.empty() ? path : std::filesystem::absolute(path, ignored).lexically_normal().string();
}

std::string commandOf(const Options& options, const permgen::Technique& technique) {
    std::vector<std::string> words;
    for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"})
        if (const char* value = std::getenv(name)) words.push_back(fmt::format("{}={}", name, value));
    if (!words.empty()) words.insert(words.begin(), "env");
    std::error_code ignored;
    words.insert(words.end(),
                 {std::filesystem::read_symlink("/proc/self/exe", ignored).string(), absolute(options.manifest),
                  absolute(options.fixture), "--technique", std::string(technique.name)});
    const auto add = [&](const char* option, const std::string& value) {
        if (!value.empty()) words.insert(words.end(), {option, value});
    };
    add("--goldens", absolute(options.goldens));
    add("--report", absolute(options.report));
    add("--device", options.device);
    return shellCommand(words);
}

void report(const Options& options, const permgen::Effect& effect, const permgen::Technique& technique,
            const CheckResult& check) {
    if (options.report.empty()) return;
    const Subject subject{std::string(effect.name), std::string(technique.name), check.pass, check.check};
    const auto reported =
        check.reason.empty()
            ? reportPass(options.report, subject)
            : reportFailure(options.report,
                            {subject, switches(technique, check.pass), check.reason, commandOf(options, technique)},
                            check.image ? &*check.image : nullptr, check.expected ? &*check.expected : nullptr);
    if (!reported) stop(reported.error().message);
}

/// A renamed or removed technique never passes again, so its failures would stay in the report.
void forgetOtherTechniques(const Options& options, const permgen::Effect& effect) {
    if (options.report.empty()) return;
    std::vector<std::string> names;
    for (const permgen::Technique& technique : effect.techniques) names.emplace_back(technique.name);
    if (const auto done = reportTechniques(options.report, std::string(effect.name), names); !done)
        stop(done.error().message);
}

bool tryOut(headless::Device& device, EffectRenderer& renderer, const permgen::Effect& effect,
            const permgen::Technique& technique, const Fixture& fixture, const Options& options) {
    const GoldenStore goldens{options.goldens, options.updateGoldens, "run permgen-rig with --update-goldens"};
    const TechniqueResult result = checkTechnique(device, renderer, effect, technique, fixture.tolerance,
                                                  options.goldens.empty() ? nullptr : &goldens);
    fmt::print("{}  {}: {} checks over {} pass{}\n", result.passed() ? "ok  " : "FAIL", technique.name,
               result.checks.size(), technique.passes.size(), technique.passes.size() == 1 ? "" : "es");
    for (const CheckResult& check : result.checks) {
        if (!check.reason.empty())
            fmt::print("      {}{}{}: {}: {}\n", technique.name, check.pass.empty() ? "" : ", pass ", check.pass,
                       check.check, check.reason);
        report(options, effect, technique, check);
    }
    for (const std::string& note : result.notes) fmt::print("      note: {}\n", note);
    std::fflush(stdout);
    return result.passed();
}

Status run(const Options& options) {
    const auto loaded = permgen::load_manifest(options.manifest);
    if (!loaded) stop(loaded.error().message);
    const permgen::Effect& whole = loaded->tables();
    const permgen::Effect effect = chosen(whole, options);
    if (options.list) {
        for (const permgen::Technique& technique : effect.techniques) fmt::print("{}\n", technique.name);
        return Passed;
    }
    const auto fixture = readFixture(options.fixture);
    if (!fixture) stop(fixture.error().message);
    checkDrawn(effect, options);
    checkFrozen(effect, options);
    headless::Device device = openDevice(options);
    const auto renderer = EffectRenderer::create(device, effect, *fixture);
    if (!renderer) stop(renderer.error().message);

    fmt::print("{}: {} of {} techniques on {}\n", effect.name, effect.techniques.size(), whole.techniques.size(),
               device.name());
    if (!(*renderer)->unsetConstants().empty())
        fmt::print("note: the fixture leaves these constants at 0: {}\n",
                   fmt::join((*renderer)->unsetConstants(), ", "));
    forgetOtherTechniques(options, whole);
    std::size_t failed = 0;
    for (const permgen::Technique& technique : effect.techniques)
        failed += !tryOut(device, **renderer, effect, technique, *fixture, options);
    if (failed == 0) return Passed;
    fmt::print(
        "{} of {} techniques failed{}\n", failed, effect.techniques.size(),
        options.report.empty() ? "; --report DIR shows their pictures" : ": see " + options.report + "/index.html");
    return Failed;
}

}  // namespace
}  // namespace tyndall::rig

int main(int argc, char** argv) {
    // Writing past a size limit or into a closed pipe is reported as an error instead of ending the program.
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
    tyndall::rig::Options options;
    if (const int status = tyndall::rig::parseOptions(argc, argv, options); status >= 0) return status;
    try {
        const auto status = tyndall::rig::run(options);
        if (std::fflush(stdout) != 0) tyndall::rig::stop("standard output cannot be written");
        return status;
    } catch (const tyndall::rig::Failing& failing) {
        fmt::print(stderr, "permgen-rig: error: {}\n", failing.sentence);
    } catch (const std::exception& error) {
        fmt::print(stderr, "permgen-rig: error: {}; this is a bug in permgen-rig, please report it\n", error.what());
    }
    return tyndall::rig::NothingTried;
}
