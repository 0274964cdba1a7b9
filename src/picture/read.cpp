// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/read.h"

#include "base/colour.h"
#include "base/elementary.h"
#include "base/gamma.h"
#include "base/video_gamma.h"
#include "picture/file_facts.h"
#include "picture/formats.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

/// Converts a stored value to a linear one by the encoding that the file declares.
double decoded(float stored, const StoredPicture& picture) {
    if (picture.linear) return stored;
    return picture.gamma > 0 ? math::pow(static_cast<double>(stored), picture.gamma)
                             : srgb_decode(stored);
}

/// Converts stored values to the scene's.
class Decoder {
public:
    Decoder(const TexelCoding& coding, const StoredPicture& picture, const FileFacts& facts)
        : coding_(coding), picture_(picture) {
        const bool said = facts.says_coding.value_or(false) || picture.linear;
        // Formats whose values POV-Ray takes as they are.
        const bool video = coding.decode == TexelCoding::always_all && picture.format == "pnm";
        const bool plain =
            (picture.format == "pnm" && !video) || (picture.format == "tiff" && !said);
        decodes_ = coding.gamma == 0 && !plain &&
                   (coding.decode >= TexelCoding::always ||
                    (coding.decode == TexelCoding::where_said && said));
        gamma_ = coding.gamma == 0 && video ? bt709_gamma : coding.gamma;
        const bool whole = keeps_whole_brightness(picture);
        for (std::size_t i = 0; i < bytes_.size(); ++i) {
            bytes_[i] = exactly(static_cast<float>(i) / 255);
            if (whole) bytes_[i] = whole_brightness(bytes_[i]);
        }
    }

    float operator()(float stored) const {
        if (picture_.bits != 8 || !(stored >= 0 && stored <= 1)) return exactly(stored);
        return bytes_[static_cast<std::size_t>(255 * stored + 0.5F)];
    }

private:
    float exactly(float stored) const {
        double value = stored;
        if (gamma_ < 0)
            value = light_of(value, gamma_);
        else if (gamma_ > 0)
            value = math::pow(std::max(0.0, value), gamma_);
        else if (decodes_)
            value = decoded(stored, picture_);
        else
            return stored;
        const bool encodes = coding_.decode != TexelCoding::as_stored;
        return static_cast<float>(encodes ? from_linear(value, coding_.working_gamma) : value);
    }

    const TexelCoding& coding_;
    const StoredPicture& picture_;
    bool decodes_;
    double gamma_;
    std::array<float, 256> bytes_{};
};

/// Undoes the multiplication of colours by their alpha.
void divide_by_alpha(StoredPicture& picture) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < picture.values.size(); ++i)
        if (const float alpha = picture.alpha[i / channels]; alpha > 0) picture.values[i] /= alpha;
}

/// Returns the table index of every pixel's colour; empty if a colour is not in the table.
std::vector<std::uint16_t> numbers_of(const StoredPicture& picture, const FileFacts& facts) {
    if (!picture.numbers.empty()) {
        const std::size_t most = *std::ranges::max_element(picture.numbers);
        return most < facts.table.size() ? picture.numbers : std::vector<std::uint16_t>();
    }
    std::vector<std::uint16_t> numbers;
    const ColourNumbers number_of(facts);
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; !facts.table.empty() && i < picture.values.size(); i += channels) {
        const float alpha = picture.alpha.empty() ? 1 : picture.alpha[i / channels];
        const std::size_t number = number_of({&picture.values[i], channels}, alpha);
        if (number >= facts.table.size()) return {};
        numbers.push_back(static_cast<std::uint16_t>(number));
    }
    return numbers;
}

}  // namespace

std::optional<Texels> read_texels(const Found& file, const TexelCoding& coding,
                                  Diagnostics& diagnostics, Span asked_at) {
    std::optional<StoredPicture> read = read_stored(file, diagnostics, asked_at);
    if (!read) return std::nullopt;
    StoredPicture& stored = *read;
    const FileFacts facts = file_facts(file);
    const Decoder decode(coding, stored, facts);
    Texels texels;
    texels.width = stored.width;
    texels.height = stored.height;
    texels.channels = stored.channels;
    texels.numbers = numbers_of(stored, facts);
    const bool opaque = std::ranges::all_of(stored.alpha, [](float alpha) { return alpha == 1; });
    if (!texels.numbers.empty()) {
        const auto value = [&](std::uint8_t byte) {
            return static_cast<double>(decode(static_cast<float>(byte) / 255));
        };
        for (const auto& [red, green, blue, alpha] : facts.table) {
            const double share = coding.premultiplied && alpha > 0 ? alpha / 255.0 : 1;
            texels.table.push_back(
                {Rgb(value(red), value(green), value(blue)) / share, 0, 1 - alpha / 255.0});
        }
        if (!opaque) texels.alpha = std::move(stored.alpha);
        texels.measure();
        return texels;
    }
    if (!opaque && stored.format == "openexr") divide_by_alpha(stored);
    for (float& value : stored.values) value = decode(value);
    // The values of other files were multiplied first and encoded afterwards.
    if (!opaque && coding.premultiplied && stored.format != "openexr") divide_by_alpha(stored);
    texels.values = std::move(stored.values);
    if (!opaque) texels.alpha = std::move(stored.alpha);
    texels.measure();
    return texels;
}

std::optional<Image> read_picture(const std::string& path, Diagnostics& diagnostics,
                                  Span asked_at) {
    const std::optional<std::string> bytes = disk_reader()(path);
    if (!bytes) {
        diagnostics.add(
            error(Fault::io, asked_at, message("cannot open the picture `", printable(path), "`")));
        return std::nullopt;
    }
    const std::optional<StoredPicture> read = read_stored({path, *bytes}, diagnostics, asked_at);
    if (!read) return std::nullopt;
    const StoredPicture& stored = *read;
    Image image(stored.width, stored.height);
    const auto channels = static_cast<std::size_t>(stored.channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto value = [&](std::size_t channel) {
            return decoded(stored.values[channels * i + std::min(channel, channels - 1)], stored);
        };
        image.pixels[i] = Rgb(value(0), value(1), value(2));
    }
    return image;
}

}  // namespace candelabra
