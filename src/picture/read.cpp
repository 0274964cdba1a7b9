// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/read.h"

#include "base/colour.h"
#include "text/harmless.h"
#include "text/message.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace {

/// Larger pictures are taken for damaged files rather than read.
constexpr std::int64_t most_pixels = std::int64_t{1} << 28;

/// From a stored value to a linear one, by what the file says about itself.
class Decoder {
public:
    explicit Decoder(const OIIO::ImageSpec& spec)
        : linear_(spec.format.is_floating_point() ||
                  spec.get_string_attribute("oiio:ColorSpace") == "Linear"),
          gamma_(spec.get_float_attribute("oiio:Gamma", 0)) {}

    double operator()(float stored) const {
        if (linear_) return stored;
        return gamma_ > 0 ? std::pow(static_cast<double>(stored), gamma_) : srgb_decode(stored);
    }

private:
    bool linear_;
    double gamma_;
};

std::optional<Image> read(OIIO::ImageInput& input) {
    const OIIO::ImageSpec& spec = input.spec();
    const int channels = spec.nchannels < 3 ? 1 : 3;
    Image image(spec.width, spec.height);
    std::vector<float> values(image.pixels.size() * static_cast<std::size_t>(channels));
    if (!input.read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, values.data()))
        return std::nullopt;
    const Decoder decode(spec);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (channels == 1)
            image.pixels[i] = Vec3(decode(values[i]));
        else
            image.pixels[i] =
                Vec3(decode(values[3 * i]), decode(values[3 * i + 1]), decode(values[3 * i + 2]));
    }
    return image;
}

}  // namespace

std::optional<Image> read_picture(const std::string& path, Diagnostics& diagnostics,
                                  Span asked_at) {
    const auto refuse = [&](const std::string& why) {
        diagnostics.add(error(Fault::io, asked_at,
                              message("cannot read the picture `", harmless(path), "`: ", why)));
        return std::nullopt;
    };
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &as_stored);
    if (!input) return refuse(harmless(OIIO::geterror()));
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || std::int64_t{spec.width} * spec.height > most_pixels)
        return refuse(message("it says that it has ", spec.width, " by ", spec.height, " pixels"));
    auto image = read(*input);
    if (!image) return refuse(harmless(input->geterror()));
    return image;
}
