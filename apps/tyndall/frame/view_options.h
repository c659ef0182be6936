// The view: a scene, a camera, a time, a size.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tyndall::app {

struct Size {
    std::uint32_t width = 640;
    std::uint32_t height = 360;
};

enum class Layer {
    All,     ///< surfaces and shafts
    Shafts,  ///< the radiance of the shafts only; surfaces occlude them
};

struct ViewOptions {
    std::string scene;                  ///< path of the glTF file
    std::optional<std::string> camera;  ///< by name; absent: the file's first
    Size size;
    double time = 0.0;  ///< seconds
    Layer layer = Layer::All;
};

}  // namespace tyndall::app
