// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/formats.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace {

using OIIO::TypeDesc;

std::string number(std::int64_t n) { return std::to_string(n); }

std::string read(const std::string& path, std::int64_t most_pixels, StoredPicture& picture) {
    OIIO::ImageSpec as_stored;
    as_stored.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &as_stored);
    if (!input) return OIIO::geterror();
    const OIIO::ImageSpec& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || std::int64_t{spec.width} * spec.height > most_pixels)
        return "it says that it has " + number(spec.width) + " by " + number(spec.height) +
               " pixels";
    picture.width = spec.width;
    picture.height = spec.height;
    picture.channels = spec.nchannels < 3 ? 1 : 3;
    picture.bits = static_cast<int>(8 * spec.format.size());
    picture.linear =
        spec.format.is_floating_point() || spec.get_string_attribute("oiio:ColorSpace") == "Linear";
    picture.gamma = spec.get_float_attribute("oiio:Gamma", 0);
    picture.values.resize(static_cast<std::size_t>(spec.width) *
                          static_cast<std::size_t>(spec.height) *
                          static_cast<std::size_t>(picture.channels));
    if (!input->read_image(0, 0, 0, picture.channels, TypeDesc::FLOAT, picture.values.data()))
        return input->geterror();
    return {};
}

struct StoredType {
    TypeDesc operator()(const std::vector<std::uint8_t>&) const { return TypeDesc::UINT8; }
    TypeDesc operator()(const std::vector<std::uint16_t>&) const { return TypeDesc::UINT16; }
    TypeDesc operator()(const std::vector<float>&) const { return TypeDesc::FLOAT; }
};

std::string write(const RawPicture& picture, std::string& bytes) {
    const TypeDesc type = std::visit(StoredType(), picture.values);
    OIIO::ImageSpec spec(picture.width, picture.height, 3, type);
    spec.attribute("oiio:ColorSpace", type == TypeDesc::FLOAT ? "Linear" : "sRGB");
    spec.attribute("Software", "Candelabra");
    // A fixed time: the same picture must give the same bytes.
    spec.attribute("DateTime", "2000:01:01 00:00:00");
    if (!picture.compression.empty())
        spec.attribute("compression", std::string(picture.compression));

    const std::string extension(picture.extension);
    std::vector<unsigned char> memory;
    OIIO::Filesystem::IOVecOutput proxy(memory);
    const auto output = OIIO::ImageOutput::create(extension);
    const auto send = [&](const auto& values) { return output->write_image(type, values.data()); };
    if (output && output->set_ioproxy(&proxy) && output->open("picture." + extension, spec) &&
        std::visit(send, picture.values) && output->close()) {
        bytes.assign(memory.begin(), memory.end());
        return {};
    }
    const std::string why = output ? output->geterror() : OIIO::geterror();
    return why.empty() ? "the format does not take it" : why;
}

}  // namespace

extern "C" const Formats* candelabra_formats() {
    static constexpr Formats formats{&read, &write};
    return &formats;
}
