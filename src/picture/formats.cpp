// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/formats.h"

#include "base/loaded_library.h"
#include "picture/tga.h"
#include "png/png.h"
#include "raster/exr_reader.h"
#include "raster/exr_writer.h"
#include "raster/hdr_writer.h"
#include "raster/pnm_writer.h"
#include "raster/raster.h"
#include "raster/tga_writer.h"
#include "raster/tiff_writer.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candelabra {

namespace {

/// Returns the way in which the picture is invalid, as a clause; empty if it is valid.
std::string problem_of(const StoredPicture& stored) {
    if (stored.width < 1 || stored.height < 1) return "it has no pixels";
    if (std::int64_t{stored.width} * stored.height > max_pixels) return "it is too large";
    if (stored.channels != 1 && stored.channels != 3) return "its channels are unknown";
    const std::size_t pixels =
        static_cast<std::size_t>(stored.width) * static_cast<std::size_t>(stored.height);
    const auto fits = [&](std::size_t size) { return size == 0 || size == pixels; };
    const bool whole = stored.values.size() == pixels * static_cast<std::size_t>(stored.channels) &&
                       fits(stored.alpha.size()) && fits(stored.numbers.size());
    return whole ? "" : "it is damaged: pixels of it are missing";
}

/// The formats that are written without the library.
struct OwnWriter {
    std::string_view extension;
    std::string (*write)(const RawPicture&, std::string& bytes);
};
constexpr auto own_writers = std::to_array<OwnWriter>({{"png", write_png},
                                                       {"tif", write_tiff},
                                                       {"exr", write_exr},
                                                       {"hdr", write_hdr},
                                                       {"ppm", write_pnm},
                                                       {"tga", write_tga}});

const OwnWriter* own_writer(std::string_view extension) {
    const auto found = std::ranges::find(own_writers, extension, &OwnWriter::extension);
    return found == own_writers.end() ? nullptr : &*found;
}

}  // namespace

bool writes_itself(std::string_view extension) { return own_writer(extension) != nullptr; }

const Formats* picture_formats(Diagnostics& diagnostics, Span asked_at) {
    static const LoadedFunction library = load_function(formats_library, formats_function);
    if (!library.address) {
        diagnostics.add(
            error(Fault::io, asked_at,
                  message("the library of picture formats cannot be opened: ", library.problem))
                .with_help("files of PNG, OpenEXR, Radiance HDR, PPM, TGA and TIFF are written "
                           "without it"));
        return nullptr;
    }
    static const Formats* const formats = reinterpret_cast<const Formats* (*)()>(library.address)();
    return formats;
}

std::optional<StoredPicture> read_stored(const Found& file, Diagnostics& diagnostics,
                                         Span asked_at) {
    StoredPicture stored;
    std::string problem;
    if (is_png(file.text)) {
        problem = read_png(file.text, max_pixels, stored);
    } else if (is_tga(file.path) && reads_tga(file.text)) {
        if (!read_tga(file.text, max_pixels, stored)) problem = "it is damaged";
    } else if (reads_exr(file.text)) {
        problem = read_exr(file.text, max_pixels, stored);
    } else if (!read_raster(file.text, max_pixels, stored)) {
        const Formats* formats = picture_formats(diagnostics, asked_at);
        if (!formats) return std::nullopt;
        problem = formats->read(file.text, max_pixels, stored);
    }
    if (problem.empty()) problem = problem_of(stored);
    if (problem.empty()) return stored;
    diagnostics.add(error(
        Fault::io, asked_at,
        message("cannot read the picture `", printable(file.path), "`: ", printable(problem))));
    return std::nullopt;
}

std::optional<std::string> write_stored(const RawPicture& picture, Diagnostics& diagnostics) {
    std::string bytes, problem;
    if (const OwnWriter* const own = own_writer(picture.extension)) {
        problem = own->write(picture, bytes);
    } else {
        const Formats* formats = picture_formats(diagnostics);
        if (!formats) return std::nullopt;
        problem = formats->write(picture, bytes);
    }
    if (problem.empty()) return bytes;
    diagnostics.add(error(Fault::io, {},
                          message("cannot make a ", picture.extension, " file of ", picture.width,
                                  " by ", picture.height, " pixels: ", problem)));
    return std::nullopt;
}

bool keeps_whole_brightness(const StoredPicture& picture) {
    return picture.format == "png" && picture.channels == 1 && picture.bits == 8 &&
           picture.alpha.empty();
}

float whole_brightness(float value) {
    const float brightness = 0.297F * value + 0.589F * value + 0.114F * value;
    return std::trunc(brightness * 255.0F) / 255.0F;
}

}  // namespace candelabra
