// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/raster.h"

#include "raster/gif.h"
#include "raster/jpeg.h"
#include "raster/pnm.h"
#include "raster/tiff.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

using namespace std::string_view_literals;

struct RasterFormat {
    std::string_view beginning;
    std::optional<StoredPicture> (*read)(std::string_view, std::int64_t);
};
constexpr auto raster_formats = std::to_array<RasterFormat>({{"GIF87a", read_gif},
                                                             {"GIF89a", read_gif},
                                                             {"\xff\xd8\xff", read_jpeg},
                                                             {"P2", read_pnm},
                                                             {"P3", read_pnm},
                                                             {"P5", read_pnm},
                                                             {"P6", read_pnm},
                                                             {"II*\0"sv, read_tiff},
                                                             {"MM\0*"sv, read_tiff}});

const RasterFormat* format_of(std::string_view bytes) {
    const auto begins = [&](const RasterFormat& format) {
        return bytes.starts_with(format.beginning);
    };
    const auto found = std::ranges::find_if(raster_formats, begins);
    return found == raster_formats.end() ? nullptr : &*found;
}

}  // namespace

bool read_raster(std::string_view bytes, std::int64_t max_pixels, StoredPicture& picture) {
    const RasterFormat* const format = format_of(bytes);
    std::optional<StoredPicture> read;
    if (format) read = format->read(bytes, max_pixels);
    if (read) picture = std::move(*read);
    return read.has_value();
}

}  // namespace candelabra
