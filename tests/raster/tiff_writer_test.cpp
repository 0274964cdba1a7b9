// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/tiff_writer.h"

#include "raster/tiff.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what is written as TIFF is read back", "[raster]") {
    for (const int channels : {1, 2, 3, 4})
        for (const bool wide : {false, true})
            for (const char* description : {"", "seed 3"}) {
                CAPTURE(channels, wide, description);
                constexpr int width = 5, height = 3;
                RawPicture picture{width, height, channels, {}, "tif", "zip", description};
                std::vector<std::uint16_t> values;
                for (int i = 0; i < width * height * channels; ++i)
                    values.push_back(static_cast<std::uint16_t>(i * 137 % (wide ? 65536 : 256)));
                if (wide)
                    picture.values = values;
                else
                    picture.values = std::vector<std::uint8_t>(values.begin(), values.end());
                std::string bytes, again;
                REQUIRE(write_tiff(picture, bytes) == "");
                REQUIRE(write_tiff(picture, again) == "");
                CHECK(bytes == again);
                CHECK((bytes.find("seed 3") != std::string::npos) == (*description != '\0'));
                const auto read = read_tiff(bytes, 1000);
                REQUIRE(read);
                CHECK(read->width == width);
                CHECK(read->bits == (wide ? 16 : 8));
                CHECK(read->channels == (channels < 3 ? 1 : 3));
                const auto colours = static_cast<std::size_t>(read->channels);
                const double most = wide ? 65535 : 255;
                for (std::size_t i = 0; i < width * height; ++i) {
                    for (std::size_t c = 0; c < colours; ++c)
                        CHECK(read->values[i * colours + c] * most ==
                              Approx(values[i * static_cast<std::size_t>(channels) + c]));
                    if (channels % 2 == 0)
                        CHECK(read->alpha[i] * most ==
                              Approx(values[(i + 1) * static_cast<std::size_t>(channels) - 1]));
                }
            }
}

}  // namespace candelabra
