#include "exr.h"

#include <OpenImageIO/deepdata.h>
#include <gtest/gtest.h>

#include <vector>

#include "glb.h"

namespace tyndall::test {
namespace {

bool writeDeep(OIIO::ImageOutput& file, const OIIO::ImageSpec& spec, const study::Image& image) {
    OIIO::DeepData data(spec);
    for (int pixel = 0; pixel < image.width * image.height; ++pixel) {
        data.set_samples(pixel, 1);
        for (int c = 0; c < image.channels; ++c)
            data.set_deep_value(pixel, c, 0, image.values[static_cast<std::size_t>(pixel * image.channels + c)]);
    }
    return file.write_deep_image(data);
}

}  // namespace

std::string writeExr(const study::Image& image, const ExrLayout& layout, const std::string& name) {
    const std::string path = freshPath(name);
    auto file = OIIO::ImageOutput::create("openexr");
    OIIO::ImageSpec spec(image.width, image.height, image.channels, layout.type);
    if (image.channels == 1) spec.channelnames = {"Y"};
    if (!layout.channels.empty()) spec.channelnames = layout.channels;
    spec.tile_width = spec.tile_height = layout.tile;
    spec.deep = layout.deep;
    if (layout.cropped) spec.full_width = image.width + 1;
    if (layout.mipLevels) spec.attribute("textureformat", "Plain Texture");
    const std::vector<OIIO::ImageSpec> specs(static_cast<std::size_t>(layout.parts), spec);
    bool written = layout.parts > 1 ? file->open(path, layout.parts, specs.data()) : file->open(path, spec);
    const auto write = [&] {
        return layout.deep ? writeDeep(*file, spec, image)
                           : file->write_image(OIIO::TypeDesc::FLOAT, image.values.data());
    };
    written = written && write();
    for (int part = 1; part < layout.parts; ++part)
        written = written && file->open(path, spec, OIIO::ImageOutput::AppendSubimage) && write();
    if (layout.mipLevels) {
        OIIO::ImageSpec half = spec;
        half.width = half.full_width = image.width / 2;
        half.height = half.full_height = image.height / 2;
        const std::vector<float> black(static_cast<std::size_t>(half.width * half.height * image.channels));
        written = written && file->open(path, half, OIIO::ImageOutput::AppendMIPLevel) &&
                  file->write_image(OIIO::TypeDesc::FLOAT, black.data());
    }
    written = written && file->close();
    EXPECT_TRUE(written) << file->geterror();
    return path;
}

}  // namespace tyndall::test
