// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/layers.h"

#include "picture/formats.h"
#include "raster/exr_reader.h"
#include "raster/exr_writer.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"

#include <algorithm>

namespace candelabra {

namespace {

bool is_whole(const LayeredPicture& picture) {
    if (picture.width < 1 || picture.height < 1) return false;
    const std::size_t pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    return std::ranges::all_of(
        picture.planes, [&](const ChannelPlane& plane) { return plane.bits.size() == pixels; });
}

}  // namespace

std::optional<std::string> encode(const LayeredPicture& picture, Diagnostics& diagnostics) {
    std::string bytes;
    const std::string problem = write_exr(picture, bytes);
    if (problem.empty()) return bytes;
    diagnostics.add(error(Fault::io, {},
                          message("cannot make an exr file of ", picture.width, " by ",
                                  picture.height, " pixels: ", printable(problem))));
    return std::nullopt;
}

std::optional<std::string> bytes_of_layers(const std::string& path, Diagnostics& diagnostics) {
    auto bytes = content_of_file(path);
    if (!bytes)
        diagnostics.add(error(Fault::io, {},
                              message("cannot read `", printable(path),
                                      "`: it cannot be opened, or is no regular file")));
    return bytes;
}

std::optional<LayeredPicture> read_layers(std::string_view bytes, const std::string& path,
                                          std::span<const std::string_view> texts,
                                          Diagnostics& diagnostics) {
    LayeredPicture picture;
    for (const std::string_view name : texts) picture.texts.emplace_back(name, "");
    std::string problem;
    if (reads_exr(bytes)) {
        problem = read_exr(bytes, max_pixels, picture);
    } else {
        const Formats* formats = picture_formats(diagnostics);
        if (!formats) return std::nullopt;
        problem = formats->read_layers(bytes, max_pixels, picture);
    }
    if (problem.empty() && !is_whole(picture)) problem = "it is damaged: pixels of it are missing";
    if (problem.empty()) return picture;
    diagnostics.add(
        error(Fault::io, {}, message("cannot read `", printable(path), "`: ", printable(problem))));
    return std::nullopt;
}

std::optional<LayeredPicture> read_layers(const std::string& path,
                                          std::span<const std::string_view> texts,
                                          Diagnostics& diagnostics) {
    // Read everything through one handle, without looking up the name again.
    const auto bytes = bytes_of_layers(path, diagnostics);
    return bytes ? read_layers(*bytes, path, texts, diagnostics) : std::nullopt;
}

}  // namespace candelabra
