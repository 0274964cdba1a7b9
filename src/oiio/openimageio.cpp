// SPDX-License-Identifier: GPL-3.0-or-later
#include "oiio/claim.h"
#include "oiio/formats.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstddef>
#include <memory>

namespace candelabra {

namespace {

using OIIO::TypeDesc;

std::string number(std::int64_t n) { return std::to_string(n); }

/// Separates the colours and alpha of pixels with `stored` interleaved channels.
void split(const std::vector<float>& all, std::size_t stored, std::size_t alpha,
           StoredPicture& picture) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    const std::size_t count = all.size() / stored;
    picture.values.reserve(count * channels);
    if (alpha < stored) picture.alpha.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float* const pixel = &all[i * stored];
        picture.values.insert(picture.values.end(), pixel, pixel + channels);
        if (alpha < stored) picture.alpha.push_back(pixel[alpha]);
    }
}

/// Replaces an empty message of a failed reader, which would count as success.
std::string said(std::string problem) {
    return problem.empty() ? "it is damaged or ends too early" : problem;
}

/// An open file in memory, with the reader of its bytes, or the reason why it could not be opened.
struct Opened {
    std::unique_ptr<OIIO::Filesystem::IOMemReader> bytes;
    std::unique_ptr<OIIO::ImageInput> input;
    std::string problem;
};

/// Returns the number of uncompressed pixel bytes by the rules of the file: with a palette, a pixel
/// is only an index. Tiles extend beyond the edge.
double stored_bytes(const OIIO::ImageSpec& spec) {
    constexpr int by_table = 3;
    const bool numbers = spec.get_int_attribute("tiff:PhotometricInterpretation") == by_table;
    const int whole = static_cast<int>(8 * spec.format.size());
    const double bits = std::min(spec.get_int_attribute("oiio:BitsPerSample", whole), whole);
    return covered(spec.width, spec.height, spec.tile_width, spec.tile_height) *
           (numbers ? 1 : spec.nchannels) * bits / 8;
}

/// Describes the error in a reader's specification of the file; empty if there is none.
std::string problem_of(const OIIO::ImageSpec& spec, std::string_view format,
                       std::int64_t max_pixels, std::size_t file_bytes) {
    if (spec.width < 1 || spec.height < 1 || std::int64_t{spec.width} * spec.height > max_pixels)
        return "its header has " + number(spec.width) + " by " + number(spec.height) + " pixels";
    if (spec.depth > 1 || spec.deep) return "it has more than one layer of pixels";
    constexpr int max_channels = 1024;
    if (spec.nchannels < 1 || spec.nchannels > max_channels)
        return "its header has " + number(spec.nchannels) + " channels";
    const std::string compression = spec.get_string_attribute("compression");
    if (compression.starts_with("ccitt"))  // a row takes at least a bit
        return too_large(spec.height, 8, file_bytes);
    return too_large(stored_bytes(spec), max_growth(format, compression), file_bytes);
}

/// Opens a file with the reader of its own format, and no other.
Opened open(std::string_view bytes, std::int64_t max_pixels, const OIIO::ImageSpec& wishes,
            std::string_view only = {}) {
    const auto fail = [](std::string problem) {
        return Opened{nullptr, nullptr, std::move(problem)};
    };
    const Claim claim = claim_of(bytes);
    if (!only.empty() && claim.format != only) return fail("it is no OpenEXR file");
    if (!claim.problem.empty()) return fail(claim.problem);
    Opened opened{std::make_unique<OIIO::Filesystem::IOMemReader>(bytes.data(), bytes.size()),
                  OIIO::ImageInput::create(std::string(claim.format)),
                  {}};
    OIIO::ImageSpec spec;
    if (!opened.input) return fail(said(OIIO::geterror()));
    // A reader that does not accept the bytes would open a file of this name.
    if (!opened.input->set_ioproxy(opened.bytes.get())) return fail("it cannot be read");
    const std::string name = "bytes." + std::string(claim.format);
    if (!opened.input->open(name, spec, wishes)) return fail(said(opened.input->geterror()));
    opened.problem = problem_of(opened.input->spec(), claim.format, max_pixels, bytes.size());
    return opened;
}

std::string read(std::string_view bytes, std::int64_t max_pixels, StoredPicture& picture) {
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const Opened opened = open(bytes, max_pixels, as_stored);
    if (!opened.problem.empty()) return opened.problem;
    const OIIO::ImageSpec& spec = opened.input->spec();
    StoredPicture made;
    made.width = spec.width;
    made.height = spec.height;
    made.channels = spec.nchannels < 3 ? 1 : 3;
    made.bits = static_cast<int>(8 * spec.format.size());
    made.linear =
        spec.format.is_floating_point() || spec.get_string_attribute("oiio:ColorSpace") == "Linear";
    made.gamma = spec.get_float_attribute("oiio:Gamma", 0);
    made.format = opened.input->format_name();
    const int stored = std::min(spec.nchannels, 4);
    std::vector<float> all(static_cast<std::size_t>(spec.width) *
                           static_cast<std::size_t>(spec.height) *
                           static_cast<std::size_t>(stored));
    if (!opened.input->read_image(0, 0, 0, stored, TypeDesc::FLOAT, all.data()))
        return said(opened.input->geterror());
    const bool has_alpha = stored == 2 || stored == 4;
    if (stored == made.channels)
        made.values = std::move(all);
    else
        split(all, static_cast<std::size_t>(stored),
              static_cast<std::size_t>(has_alpha ? stored - 1 : stored), made);
    picture = std::move(made);
    return {};
}

struct StoredType {
    TypeDesc operator()(const std::vector<std::uint8_t>&) const { return TypeDesc::UINT8; }
    TypeDesc operator()(const std::vector<std::uint16_t>&) const { return TypeDesc::UINT16; }
    TypeDesc operator()(const std::vector<float>&) const { return TypeDesc::FLOAT; }
};

/// Encodes a picture in memory. `send` writes the pixels to the output.
template <class Send>
std::string to_memory(const std::string& extension, const OIIO::ImageSpec& spec, const Send& send,
                      std::string& bytes) {
    std::vector<unsigned char> memory;
    OIIO::Filesystem::IOVecOutput proxy(memory);
    const auto output = OIIO::ImageOutput::create(extension);
    if (output && output->set_ioproxy(&proxy) && output->open("picture." + extension, spec) &&
        send(*output) && output->close()) {
        bytes.assign(memory.begin(), memory.end());
        return {};
    }
    const std::string why = output ? output->geterror() : OIIO::geterror();
    return why.empty() ? "the format does not take it" : why;
}

/// The date of a picture. The library would write the current one, by which the same picture would
/// have other bytes each time; OpenEXR files may have none, in others a date must be one.
std::string_view fixed_time(std::string_view extension) {
    return extension == "exr" ? "" : "2000:01:01 00:00:00";
}

std::string write(const RawPicture& picture, std::string& bytes) {
    const TypeDesc type = std::visit(StoredType(), picture.values);
    OIIO::ImageSpec spec(picture.width, picture.height, picture.channels, type);
    if (type != TypeDesc::FLOAT) spec.attribute("oiio:UnassociatedAlpha", 1);
    const bool linear = type == TypeDesc::FLOAT || picture.gamma == 1;
    spec.attribute("oiio:ColorSpace", linear ? "Linear" : "sRGB");
    spec.attribute("Software", "Candelabra");
    spec.attribute("DateTime", std::string(fixed_time(picture.extension)));
    if (!picture.description.empty()) spec.attribute("ImageDescription", picture.description);
    if (!picture.compression.empty())
        spec.attribute("compression", std::string(picture.compression));

    const auto send = [&](OIIO::ImageOutput& output) {
        return std::visit(
            [&](const auto& values) { return output.write_image(type, values.data()); },
            picture.values);
    };
    return to_memory(std::string(picture.extension), spec, send, bytes);
}

std::string read_layers(std::string_view bytes, std::int64_t max_pixels, LayeredPicture& picture) {
    const Opened opened = open(bytes, max_pixels, {}, "openexr");
    if (!opened.problem.empty()) return opened.problem;
    const OIIO::ImageSpec& spec = opened.input->spec();
    const std::int64_t pixels = std::int64_t{spec.width} * spec.height;
    picture.width = spec.width;
    picture.height = spec.height;
    for (auto& [name, text] : picture.texts) text = spec.get_string_attribute(name);
    // Floats of other sizes are converted; integers would lose bits.
    bool as_stored = true, whole_numbers = false;
    for (int c = 0; c < spec.nchannels; ++c) {
        as_stored &= spec.channelformat(c).size() == sizeof(std::uint32_t);
        whole_numbers |= !spec.channelformat(c).is_floating_point();
    }
    if (!as_stored && whole_numbers) return "its channels do not have 32 bits each";
    // All at once, since reading one channel decodes the whole file, too.
    const auto count = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::uint32_t> side_by_side(static_cast<std::size_t>(pixels) * count);
    const TypeDesc type = as_stored ? TypeDesc::UNKNOWN : TypeDesc::FLOAT;
    if (!opened.input->read_image(0, 0, 0, spec.nchannels, type, side_by_side.data()))
        return said(opened.input->geterror());
    for (std::size_t c = 0; c < count; ++c) {
        const bool whole = spec.channelformat(static_cast<int>(c)) == TypeDesc::UINT32;
        ChannelPlane plane{spec.channelnames[c], whole, {}};
        plane.bits.reserve(static_cast<std::size_t>(pixels));
        for (std::size_t i = c; i < side_by_side.size(); i += count)
            plane.bits.push_back(side_by_side[i]);
        picture.planes.push_back(std::move(plane));
    }
    return {};
}

std::string write_layers(const LayeredPicture& picture, std::string& bytes) {
    const std::size_t count = picture.planes.size();
    OIIO::ImageSpec spec(picture.width, picture.height, static_cast<int>(count), TypeDesc::FLOAT);
    spec.channelnames.clear();
    for (const ChannelPlane& plane : picture.planes) {
        spec.channelnames.push_back(plane.name);
        spec.channelformats.push_back(plane.whole ? TypeDesc::UINT32 : TypeDesc::FLOAT);
    }
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("Software", "Candelabra");
    spec.attribute("DateTime", std::string(fixed_time("exr")));
    spec.attribute("compression", "zip");
    for (const auto& [name, text] : picture.texts) spec.attribute(name, text);
    const std::size_t pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    std::vector<std::uint32_t> side_by_side(pixels * count);
    for (std::size_t c = 0; c < count; ++c)
        for (std::size_t i = 0; i < pixels; ++i)
            side_by_side[i * count + c] = picture.planes[c].bits[i];
    const auto send = [&](OIIO::ImageOutput& output) {
        return output.write_image(TypeDesc::UNKNOWN, side_by_side.data());
    };
    return to_memory("exr", spec, send, bytes);
}

}  // namespace

extern "C" const Formats* candelabra_formats() {
    static constexpr Formats formats{&read, &write, &read_layers, &write_layers};
    return &formats;
}

}  // namespace candelabra
