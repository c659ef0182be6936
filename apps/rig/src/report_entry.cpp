#include "report_entry.h"

#include <kit/image/files.h>
#include <rig/compare.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "display.h"

namespace tyndall::rig {
namespace {

using Json = nlohmann::ordered_json;

Json figures(const Image* image, const Image* expected) {
    Json json = Json::object();
    if (image) {
        const study::NonFinite bad = study::countNonFinite(*image);
        json["size"] = {image->width, image->height};
        json["nan"] = bad.nan;
        json["infinite"] = bad.infinite;
        if (bad.count() > 0)
            json["first_not_finite"] = {{"pixel", {bad.first->x, bad.first->y}}, {"channel", bad.first->channel}};
    }
    if (image && expected && image->sameShape(*expected)) {
        const Difference apart = difference(*image, *expected);
        json["largest_difference"] = apart.largest;
        json["largest_difference_at"] = {{"pixel", {apart.at.x, apart.at.y}}, {"channel", apart.at.channel}};
        // JSON has no infinity; the figure is infinite if the expected picture is black.
        json["relative_l2"] = std::isfinite(apart.relativeL2) ? Json(apart.relativeL2) : Json(nullptr);
        json["differing_values"] = apart.differing;
    }
    return json;
}

struct Panel {
    std::string name;
    const Image* image;
    std::vector<std::uint8_t> rgb;
};

Result<void> writePanel(const std::filesystem::path& folder, const Panel& panel) {
    if (auto written = writeExr((folder / (panel.name + ".exr")).string(), *panel.image); !written) return written;
    return writePng((folder / (panel.name + ".png")).string(), panel.image->width, panel.image->height, panel.rgb);
}

}  // namespace

Result<void> writeEntry(const std::filesystem::path& folder, const Failure& failure, const Image* image,
                        const Image* expected) {
    const double white = whitePoint(image, expected);
    Json json = {{"effect", failure.subject.effect}, {"technique", failure.subject.technique},
                 {"pass", failure.subject.pass},     {"check", failure.subject.check},
                 {"reason", failure.reason},         {"command", failure.command}};
    Json constants = Json::object();
    for (const auto& [name, value] : failure.constants) constants[name] = value;
    json["constants"] = std::move(constants);
    json["figures"] = figures(image, expected);

    std::vector<Panel> panels;
    Image apart;
    if (image) panels.push_back({"image", image, displayed(*image, white)});
    if (expected) panels.push_back({"expected", expected, displayed(*expected, white)});
    if (image && expected && image->sameShape(*expected)) {
        apart = absoluteDifference(*image, *expected);
        const double max = difference(*image, *expected).largest;
        panels.push_back({"difference", &apart, heatMap(apart, std::max(max, 1e-300))});
    }
    Json pictures = Json::array();
    for (const Panel& panel : panels) {
        if (auto written = writePanel(folder, panel); !written) return written;
        pictures.push_back(panel.name);
    }
    json["pictures"] = std::move(pictures);
    json["white"] = white;
    const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    return writeFile((folder / "entry.json").string(), text);
}

}  // namespace tyndall::rig
