// Image files keep every bit, and equal images give equal files.
#include <gtest/gtest.h>
#include <rig/image.h>

#include <bit>
#include <cmath>
#include <limits>

#include "folder.h"

namespace tyndall::rig {
namespace {

TEST(ImageFile, ExrKeepsEveryBitOfOneToFourChannels) {
    const test::Folder folder;
    for (int channels = 1; channels <= 4; ++channels) {
        Image image = blankImage(7, 5, channels);
        for (std::size_t i = 0; i < image.values.size(); ++i)
            image.values[i] = std::ldexp(static_cast<float>(i) / 3.0f - 4.0f, static_cast<int>(i % 60) - 30);
        image.values[0] = -0.0f;
        image.values[1] = std::numeric_limits<float>::infinity();
        image.values[2] = std::numeric_limits<float>::quiet_NaN();
        image.values[3] = std::numeric_limits<float>::denorm_min();
        const std::string path = folder.at("x.exr");
        ASSERT_TRUE(writeExr(path, image).has_value());
        const auto read = readImage(path);
        ASSERT_TRUE(read.has_value()) << read.error().message;
        ASSERT_TRUE(read->sameShape(image));
        for (std::size_t i = 0; i < image.values.size(); ++i)
            EXPECT_EQ(std::bit_cast<std::uint32_t>(read->values[i]), std::bit_cast<std::uint32_t>(image.values[i]))
                << i;
    }
}

TEST(ImageFile, TheSameImageMakesTheSameBytes) {
    const test::Folder folder;
    Image image = blankImage(9, 9, 4);
    image.values[17] = 0.25f;
    ASSERT_TRUE(writeExr(folder.at("a.exr"), image).has_value());
    ASSERT_TRUE(writeExr(folder.at("b.exr"), image).has_value());
    EXPECT_EQ(test::readText(folder.at("a.exr")), test::readText(folder.at("b.exr")));
    EXPECT_EQ(test::listing(folder.path()), "a.exr\nb.exr\n");
}

TEST(ImageFile, PngComesBackAsStored) {
    const test::Folder folder;
    ASSERT_TRUE(writePng(folder.at("x.png"), 2, 1, {255, 128, 0, 1, 2, 3}).has_value());
    const auto read = readImage(folder.at("x.png"));
    ASSERT_TRUE(read.has_value()) << read.error().message;
    EXPECT_EQ(read->channels, 3);
    EXPECT_EQ(read->at(0, 0, 0), 1.0f);
    EXPECT_FLOAT_EQ(read->at(0, 0, 1), 128.0f / 255.0f);
    EXPECT_FLOAT_EQ(read->at(1, 0, 2), 3.0f / 255.0f);
}

TEST(ImageFile, WhatCannotBeReadOrWrittenIsSaidInOneSentence) {
    const test::Folder folder;
    EXPECT_EQ(readImage(folder.at("x.exr")).error().message,
              folder.at("x.exr") + ": cannot be read: there is no such file");
    test::writeText(folder.at("bad.exr"), "no image");
    EXPECT_NE(readImage(folder.at("bad.exr")).error().message.find("cannot be read"), std::string::npos);
    const auto written = writeExr(folder.at("missing/x.exr"), blankImage(1, 1, 1));
    ASSERT_FALSE(written.has_value());
    EXPECT_NE(written.error().message.find("cannot be written"), std::string::npos);
}

}  // namespace
}  // namespace tyndall::rig
