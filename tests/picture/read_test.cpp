// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/read.h"

#include "picture/file.h"
#include "picture/write.h"
#include "support/folder.h"
#include "support/found.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <fstream>

namespace candelabra {

namespace {

Image sample() {
    Image image(3, 2);
    image.at(0, 0) = Rgb(1, 0, 0);
    image.at(1, 0) = Rgb(0.25, 0.5, 0.75);
    image.at(2, 0) = Rgb(0.01, 0.1, 0.9);
    image.at(0, 1) = Rgb(0);
    image.at(1, 1) = Rgb(0.5, 0.5, 0.5);
    image.at(2, 1) = Rgb(0, 0, 1);
    return image;
}

}  // namespace

TEST_CASE("what is written is read back, as exactly as the format allows") {
    struct Case {
        PictureFormat format;
        double tolerance;
    };
    const Case cases[] = {
        {{PictureType::png, 8}, 5e-3},   {{PictureType::png, 16}, 3e-5},
        {{PictureType::exr, 8}, 1e-7},   {{PictureType::hdr, 8}, 5e-3},
        {{PictureType::ppm, 8}, 5e-3},   {{PictureType::tga, 8}, 5e-3},
        {{PictureType::bmp, 8}, 5e-3},   {{PictureType::tiff, 8}, 5e-3},
        {{PictureType::tiff, 16}, 3e-5},
    };
    const Folder folder;
    const Image image = sample();
    for (const Case& each : cases) {
        const std::string path = folder / ("picture." + std::string(extension(each.format.type)));
        CAPTURE(path, each.format.bits);
        Diagnostics diagnostics;
        REQUIRE(write_picture(image, path, each.format, diagnostics));
        const auto back = read_picture(path, diagnostics);
        REQUIRE(back);
        REQUIRE(back->width == image.width);
        REQUIRE(back->height == image.height);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            CAPTURE(i);
            CHECK(max_abs_component(back->pixels[i] - image.pixels[i]) <= each.tolerance);
        }
    }
}

TEST_CASE("the linear formats keep what no display can show") {
    const Folder folder;
    Image image(1, 1);
    image.at(0, 0) = Rgb(1000, 0.001, 2);
    Diagnostics diagnostics;
    for (const PictureType type : {PictureType::exr, PictureType::hdr}) {
        const std::string path = folder / ("bright." + std::string(extension(type)));
        REQUIRE(write_picture(image, path, {type}, diagnostics));
        const auto back = read_picture(path, diagnostics);
        REQUIRE(back);
        CHECK(std::abs(back->at(0, 0).r - 1000) < 4);
        CHECK(std::abs(back->at(0, 0).b - 2) < 4);
    }
}

TEST_CASE("what is no picture is an error that names the file") {
    const Folder folder;
    std::ofstream(folder / "text.png") << "this is no picture";
    std::ofstream(folder / "empty.exr");
    for (const char* name : {"missing.png", "text.png", "empty.exr", "unknown.kind"}) {
        CAPTURE(name);
        Diagnostics diagnostics;
        const Span span{0, 3, 5};
        CHECK_FALSE(read_picture(folder / name, diagnostics, span));
        REQUIRE(diagnostics.error_count() == 1);
        CHECK(diagnostics.all()[0].fault == Fault::io);
        CHECK(diagnostics.all()[0].span == span);
        CHECK(diagnostics.all()[0].message.find(name) != std::string::npos);
    }
}

TEST_CASE("greys of PNG files are those that POV-Ray keeps", "[picture]") {
    const Folder folder;
    constexpr std::array stored = {2, 4, 5, 6, 10, 11, 254, 255};
    constexpr std::array kept = {2, 4, 4, 5, 9, 11, 253, 255};
    Image image(8, 1);
    for (std::size_t i = 0; i < stored.size(); ++i) image.pixels[i] = Rgb(stored[i] / 255.0);
    const std::string path = folder / "grey.png";
    PictureFormat format;
    format.grey = true;
    format.encoded = false;
    Diagnostics diagnostics;
    REQUIRE(write_picture(image, path, format, diagnostics));
    TexelCoding coding;
    coding.decode = TexelCoding::as_stored;
    const auto texels = read_texels(found(path), coding, diagnostics);
    REQUIRE(texels);
    REQUIRE(texels->values.size() == kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i)
        CHECK(255 * texels->values[i] == Approx(kept[i]).margin(1e-4));
}

TEST_CASE("texels are coded as the scene wants them", "[picture]") {
    const Folder folder;
    const std::string plain = folder / "plain.ppm";
    std::ofstream(plain, std::ios::binary) << std::string("P6 1 1 255\n\x80\x00\xff", 14);
    const auto red = [&](const TexelCoding& coding) {
        Diagnostics diagnostics;
        const auto texels = read_texels(found(plain), coding, diagnostics);
        REQUIRE(texels);
        CHECK(texels->greatest.b == 1);
        return texels->values.at(0);
    };
    TexelCoding coding;
    CHECK(red(coding) == Approx(128 / 255.0));  // PPM values are taken as they are
    coding.gamma = 2;
    CHECK(red(coding) == Approx(0.25198).epsilon(1e-4));
    coding.working_gamma = 2;
    CHECK(red(coding) == Approx(128 / 255.0));
    coding.gamma = -1;
    coding.decode = TexelCoding::as_stored;
    CHECK(red(coding) == Approx(0.21586).epsilon(1e-4));
    Diagnostics diagnostics;
    CHECK_FALSE(read_texels(found(folder / "none.png"), {}, diagnostics));
    CHECK(diagnostics.failed());
}

TEST_CASE("nobody reads on what another reader has left", "[picture]") {
    using namespace std::string_literals;
    const Folder folder;
    const std::pair<const char*, std::string> files[] = {
        // The last pixel's colour index is not in the table.
        {"a.tga", "\0\1\1\0\0\1\0\x18\0\0\0\0\2\0\2\0\x8\x20"s + "abc" + "\0\0\0\7"s},
        {"short.ppm", "P6\n4 4\n255\nabc"},
        {"a.dpx", "SDPX" + std::string(2048, '\0')}};
    for (const auto& [name, bytes] : files) {
        CAPTURE(name);
        std::ofstream(folder / name, std::ios::binary) << bytes;
        Diagnostics diagnostics;
        CHECK_FALSE(read_picture(folder / name, diagnostics, {}));
        CHECK_FALSE(read_texels(found(folder / name), {}, diagnostics, {}));
        CHECK(diagnostics.failed());
    }
}

}  // namespace candelabra
