#include <kit/image/image.h>

#include <cmath>

#include "add_options.h"

namespace tyndall::app {

void addViewOptions(CLI::App& app, ViewOptions& view, std::string& size) {
    app.add_option("scene", view.scene, "glTF file, .glb or .gltf")->required()->type_name("SCENE");
    addOptional(app, "--camera", view.camera, "NAME", "camera to look through; the file's first");
    app.add_option("--size", size, "width and height in pixels; 640x360")->type_name("WxH");
    app.add_option("--time", view.time, "moment of the animations, seconds; 0")->type_name("S");
}

Result<void> checkView(ViewOptions& view, const std::string& size) {
    const auto parsed = parseSize(size);
    if (!parsed) return tl::unexpected(parsed.error());
    view.size = *parsed;
    if (!std::isfinite(view.time)) return fail("--time: must be a finite number of seconds");
    return {};
}

void addTechnique(CLI::App& app, std::optional<TermSet>& terms, const std::string& help) {
    app.add_option_function<std::string>(
           "--technique",
           [&terms](const std::string& name) {
               const auto parsed = parseTechnique(name);
               if (!parsed) throw CLI::ValidationError(parsed.error().message);
               terms = *parsed;
           },
           help)
        ->type_name("NAME");
}

void addShadowSize(CLI::App& app, std::uint32_t& size) {
    app.add_option("--shadow-size", size, "texels a side of a shadow map, 1 to 16384; 1024")->type_name("N");
}

Result<void> checkShadowSize(std::uint32_t size) {
    if (size < 1 || size > longestSide)
        return fail("--shadow-size: {} is out of bounds; take from 1 to {}", size, longestSide);
    return {};
}

}  // namespace tyndall::app
