// SPDX-License-Identifier: GPL-3.0-or-later
#include "png/png.h"

#include "base/size_product.h"

#include <cmath>
#include <csetjmp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>

#include <png.h>

namespace candelabra {

namespace {

/// State of the calls of libpng. On an error they jump to `failed`. Functions that set this jump
/// must not hold objects with destructors.
struct PngWork {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::jmp_buf failed;
    std::string problem;
    std::string_view input;  ///< unread bytes
    std::string* output = nullptr;
    std::size_t file_row = 0;  ///< packed size of a row in bytes
};

PngWork& work_of(png_structp png) { return *static_cast<PngWork*>(png_get_error_ptr(png)); }

[[noreturn]] void fail(png_structp png, const char* why) {
    PngWork& work = work_of(png);
    work.problem = why;
    std::longjmp(work.failed, 1);
}

void ignore(png_structp, const char*) {}

void take_bytes(png_structp png, png_bytep target, std::size_t count) {
    std::string_view& input = work_of(png).input;
    if (count > input.size()) fail(png, "the file ends too early");
    std::memcpy(target, input.data(), count);
    input.remove_prefix(count);
}

void give_bytes(png_structp png, png_bytep source, std::size_t count) {
    work_of(png).output->append(reinterpret_cast<const char*>(source), count);
}

void flush(png_structp) {}

bool numbers_colours(const PngWork& work) {
    return png_get_color_type(work.png, work.info) == PNG_COLOR_TYPE_PALETTE;
}

/// Reads the header and selects the pixel format: channels of 8 or 16 bits, with transparency as an
/// alpha channel. Palette indices are kept.
bool read_head(PngWork& work) {
    if (setjmp(work.failed) != 0) return false;
    png_set_read_fn(work.png, &work, take_bytes);
    png_read_info(work.png, work.info);
    work.file_row = png_get_rowbytes(work.png, work.info);
    if (numbers_colours(work))
        png_set_packing(work.png);
    else
        png_set_expand(work.png);
    png_set_interlace_handling(work.png);
    png_read_update_info(work.png, work.info);
    return true;
}

bool read_rows(PngWork& work, png_bytepp rows) {
    if (setjmp(work.failed) != 0) return false;
    png_read_image(work.png, rows);
    return true;
}

/// Returns a value from 0 to 1. One byte is rounded as OpenImageIO does. Two bytes are big-endian
/// and rounded so that 255 times a value is an integer where it should be.
float value_at(const png_byte* bytes, std::size_t i, bool wide) {
    if (!wide) return static_cast<float>(bytes[i]) * (1.0F / 255);
    return static_cast<float>(bytes[2 * i] << 8 | bytes[2 * i + 1]) / 65535;
}

/// Reads the colour encoding that the file declares.
void read_coding(PngWork& work, StoredPicture& picture) {
    double exponent = 0;
    int intent = 0;
    if (png_get_sRGB(work.png, work.info, &intent) != 0) return;
    if (png_get_gAMA(work.png, work.info, &exponent) == 0 || exponent <= 0) return;
    // Files store more digits than are meaningful.
    const double gamma = std::round(100 / exponent) / 100;
    picture.linear = gamma == 1;
    picture.gamma = gamma;
}

/// Looks up the colours and alpha of palette indices. Returns an error message for an invalid
/// index.
std::string look_up(PngWork& work, std::span<const png_byte> numbers, StoredPicture& picture) {
    png_colorp colours = nullptr;
    png_bytep alphas = nullptr;
    int colour_count = 0, alpha_count = 0;
    png_get_PLTE(work.png, work.info, &colours, &colour_count);
    png_get_tRNS(work.png, work.info, &alphas, &alpha_count, nullptr);
    picture.channels = 3;
    for (const png_byte number : numbers) {
        if (number >= colour_count) return "a pixel has a colour that the table has not";
        const png_color& colour = colours[number];
        for (const png_byte value : {colour.red, colour.green, colour.blue})
            picture.values.push_back(value_at(&value, 0, false));
        if (alpha_count > 0)
            picture.alpha.push_back(number < alpha_count
                                        ? value_at(alphas, static_cast<std::size_t>(number), false)
                                        : 1);
        picture.numbers.push_back(number);
    }
    return {};
}

std::string read(PngWork& work, std::int64_t max_pixels, StoredPicture& picture) {
    const std::size_t file_bytes = work.input.size();
    if (!read_head(work)) return work.problem;
    const std::int64_t width = png_get_image_width(work.png, work.info),
                       height = png_get_image_height(work.png, work.info);
    if (width * height > max_pixels)
        return "its header has " + std::to_string(width) + " by " + std::to_string(height) +
               " pixels";
    // Deflate expands two bits to at most 258 bytes.
    constexpr std::size_t max_growth = 1032;
    if (size_product(work.file_row, static_cast<std::size_t>(height)) >
        size_product(max_growth, file_bytes))
        return "its header is for a larger picture than its " + std::to_string(file_bytes) +
               " bytes can hold";
    const std::size_t stored = png_get_channels(work.png, work.info);
    const bool wide = png_get_bit_depth(work.png, work.info) == 16;
    picture.width = static_cast<int>(width);
    picture.height = static_cast<int>(height);
    picture.channels = stored < 3 ? 1 : 3;
    picture.bits = wide ? 16 : 8;
    picture.format = "png";
    read_coding(work, picture);

    const std::size_t row = png_get_rowbytes(work.png, work.info);
    std::vector<png_byte> bytes(row * static_cast<std::size_t>(height));
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y)
        rows.push_back(bytes.data() + row * y);
    if (!read_rows(work, rows.data())) return work.problem;

    const auto colours = static_cast<std::size_t>(picture.channels);
    const auto pixels = static_cast<std::size_t>(width * height);
    if (numbers_colours(work)) return look_up(work, bytes, picture);
    picture.values.reserve(pixels * colours);
    if (stored > colours) picture.alpha.reserve(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < colours; ++c)
            picture.values.push_back(value_at(bytes.data(), i * stored + c, wide));
        if (stored > colours)
            picture.alpha.push_back(value_at(bytes.data(), i * stored + colours, wide));
    }
    return {};
}

/// Converts integers to big-endian bytes.
struct RowBytes {
    std::vector<png_byte> operator()(const std::vector<std::uint8_t>& values) const {
        return values;
    }
    std::vector<png_byte> operator()(const std::vector<std::uint16_t>& values) const {
        std::vector<png_byte> bytes;
        bytes.reserve(2 * values.size());
        for (const std::uint16_t value : values) {
            bytes.push_back(static_cast<png_byte>(value >> 8));
            bytes.push_back(static_cast<png_byte>(value & 0xff));
        }
        return bytes;
    }
    std::vector<png_byte> operator()(const std::vector<float>&) const { return {}; }
};

/// Writes how the values are encoded. Versions of libpng would write these chunks in different
/// orders.
void write_coding(png_structp png, double gamma) {
    const auto chunk = [&](const char* name, std::initializer_list<std::uint32_t> numbers) {
        png_byte bytes[32];
        std::size_t size = 0;
        for (const std::uint32_t number : numbers)
            for (const int shift : {24, 16, 8, 0})
                bytes[size++] = static_cast<png_byte>(number >> shift & 0xff);
        png_write_chunk(png, reinterpret_cast<png_const_bytep>(name), bytes, size);
    };
    // In 100,000ths; the primaries are those of sRGB: white, red, green and blue.
    chunk("gAMA", {gamma > 0 ? static_cast<std::uint32_t>(std::lround(100000 / gamma)) : 45455});
    if (gamma > 0) return;
    constexpr png_byte intent = PNG_sRGB_INTENT_PERCEPTUAL;
    png_write_chunk(png, reinterpret_cast<png_const_bytep>("sRGB"), &intent, 1);
    chunk("cHRM", {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
}

bool write(PngWork& work, const RawPicture& picture, int bits, std::span<png_text> texts,
           png_bytepp rows) {
    static constexpr int colour_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                           PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
    if (setjmp(work.failed) != 0) return false;
    png_set_write_fn(work.png, &work, give_bytes, flush);
    png_set_IHDR(work.png, work.info, static_cast<png_uint_32>(picture.width),
                 static_cast<png_uint_32>(picture.height), bits, colour_types[picture.channels - 1],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info_before_PLTE(work.png, work.info);
    write_coding(work.png, picture.gamma);
    png_set_text(work.png, work.info, texts.data(), static_cast<int>(texts.size()));
    png_write_info(work.png, work.info);
    png_write_image(work.png, rows);
    png_write_end(work.png, nullptr);
    return true;
}

png_text text(std::string& key, std::string& value) {
    png_text one{};
    one.compression = PNG_TEXT_COMPRESSION_NONE;
    one.key = key.data();
    one.text = value.data();
    one.text_length = value.size();
    return one;
}

}  // namespace

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

std::string read_png(std::string_view bytes, std::int64_t max_pixels, StoredPicture& picture) {
    PngWork work;
    work.input = bytes;
    work.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &work, fail, ignore);
    work.info = png_create_info_struct(work.png);
    StoredPicture made;
    const std::string problem = read(work, max_pixels, made);
    png_destroy_read_struct(&work.png, &work.info, nullptr);
    if (problem.empty()) picture = std::move(made);
    return problem;
}

std::string write_png(const RawPicture& picture, std::string& bytes) {
    std::vector<png_byte> values = std::visit(RowBytes(), picture.values);
    const auto height = static_cast<std::size_t>(picture.height);
    if (values.empty() || values.size() % height != 0) return "it has no whole numbers";
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < height; ++y)
        rows.push_back(values.data() + values.size() / height * y);
    std::string keys[] = {"Software", "Description"};
    std::string said[] = {"Candelabra", picture.description};
    png_text texts[] = {text(keys[0], said[0]), text(keys[1], said[1])};

    PngWork work;
    work.output = &bytes;
    work.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &work, fail, ignore);
    work.info = png_create_info_struct(work.png);
    const bool wide = std::holds_alternative<std::vector<std::uint16_t>>(picture.values);
    const bool written = write(work, picture, wide ? 16 : 8,
                               {texts, picture.description.empty() ? 1u : 2u}, rows.data());
    png_destroy_write_struct(&work.png, &work.info);
    return written ? std::string() : work.problem;
}

}  // namespace candelabra
