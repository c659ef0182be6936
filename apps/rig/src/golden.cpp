#include <fmt/format.h>
#include <rig/golden.h>

#include <filesystem>

namespace tyndall::rig {
namespace {

GoldenVerdict update(const std::string& path, const Image& image, GoldenVerdict verdict) {
    if (!whyNotFinite(image).empty()) {
        verdict.reason += "; it was not written as the golden";
        return verdict;
    }
    std::error_code error;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
    if (const auto written = writeExr(path, image); !written)
        verdict.reason = written.error().message;
    else
        verdict.reason =
            fmt::format("the golden {} was {}; look at it, keep it with the sources, and run again without the switch",
                        path, verdict.expected ? "replaced (" + verdict.reason + ")" : "made");
    return verdict;
}

}  // namespace

GoldenVerdict checkGolden(const GoldenStore& store, const std::string& name, const Image& image, Tolerance tolerance) {
    const std::string path = (std::filesystem::path(store.folder) / (name + ".exr")).string();
    GoldenVerdict verdict;
    std::error_code error;
    if (std::filesystem::exists(path, error)) {
        auto golden = readImage(path);
        if (golden) {
            verdict.expected = std::move(*golden);
            verdict.reason = whyDifferent(image, *verdict.expected, tolerance);
        } else {
            verdict.reason = golden.error().message;
        }
    } else {
        verdict.reason = whyNotFinite(image);
        if (verdict.reason.empty()) verdict.reason = "there is no golden " + path;
    }
    if (verdict.passed()) return verdict;
    if (store.update) return update(path, image, std::move(verdict));
    verdict.reason += fmt::format("; if the picture is right, {} to make it the golden", store.remedy);
    return verdict;
}

}  // namespace tyndall::rig
