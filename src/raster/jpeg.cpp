// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/jpeg.h"

#include "base/size_product.h"
#include "raster/bytes.h"

#ifdef CANDELABRA_JPEG

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

namespace candelabra {

namespace {

/// State of the calls of libjpeg. On an error or a warning of damage, they jump to `failed`.
/// Functions that set this jump must not hold objects with destructors.
struct JpegWork {
    jpeg_decompress_struct info{};
    jpeg_error_mgr errors{};
    std::jmp_buf failed{};
};

[[noreturn]] void leave_jpeg(j_common_ptr info) {
    std::longjmp(static_cast<JpegWork*>(info->client_data)->failed, 1);
}

void note_jpeg(j_common_ptr info, int level) {
    if (level < 0) leave_jpeg(info);
}

bool begin_jpeg(JpegWork& work, std::string_view bytes) {
    work.info.err = jpeg_std_error(&work.errors);
    work.info.client_data = &work;
    work.errors.error_exit = leave_jpeg;
    work.errors.emit_message = note_jpeg;
    if (setjmp(work.failed) != 0) return false;
    jpeg_create_decompress(&work.info);
    jpeg_mem_src(&work.info, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    return jpeg_read_header(&work.info, TRUE) == JPEG_HEADER_OK;
}

bool decode_jpeg(JpegWork& work, unsigned char* pixels) {
    if (setjmp(work.failed) != 0) return false;
    if (jpeg_start_decompress(&work.info) == FALSE) return false;
    const std::size_t row =
        std::size_t{work.info.output_width} * static_cast<std::size_t>(work.info.output_components);
    while (work.info.output_scanline < work.info.output_height) {
        JSAMPROW target = pixels + row * work.info.output_scanline;
        jpeg_read_scanlines(&work.info, &target, 1);
    }
    return jpeg_finish_decompress(&work.info) == TRUE;
}

std::optional<StoredPicture> read_with(JpegWork& work, std::string_view bytes,
                                       std::int64_t max_pixels) {
    // A bit encodes at most one block of 64 values of a component, and a component may have only
    // one pixel of each block.
    constexpr std::size_t growth = 2048;
    if (!begin_jpeg(work, bytes)) return std::nullopt;
    const int components = work.info.num_components;
    const std::int64_t width = work.info.image_width, height = work.info.image_height;
    if ((components != 1 && components != 3) || !has_size(width, height, max_pixels))
        return std::nullopt;
    const auto count = static_cast<std::size_t>(width * height * components);
    if (count > size_product(growth, bytes.size())) return std::nullopt;
    std::vector<unsigned char> pixels(count);
    if (!decode_jpeg(work, pixels.data())) return std::nullopt;
    StoredPicture picture;
    picture.width = static_cast<int>(width);
    picture.height = static_cast<int>(height);
    picture.channels = components;
    picture.format = "jpeg";
    picture.values.reserve(count);
    for (const unsigned char value : pixels) picture.values.push_back(unit_value(value));
    return picture;
}

}  // namespace

std::optional<StoredPicture> read_jpeg(std::string_view bytes, std::int64_t max_pixels) {
    JpegWork work;
    auto picture = read_with(work, bytes, max_pixels);
    jpeg_destroy_decompress(&work.info);
    return picture;
}

}  // namespace candelabra

#else

namespace candelabra {

std::optional<StoredPicture> read_jpeg(std::string_view, std::int64_t) { return std::nullopt; }

}  // namespace candelabra

#endif
