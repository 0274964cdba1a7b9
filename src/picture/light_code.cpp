// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/light_code.h"

#include "base/elementary.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include <zlib.h>

namespace candelabra {

namespace {

using Coefficients = std::vector<float>;

/// The steps of the lifting, and the factor that makes the transform nearly orthonormal.
constexpr double lifting[] = {-1.586134342059924, -0.052980118572961, 0.882911075530934,
                              0.443506852043971};
constexpr double even_scale = 1.149604398860241;

constexpr double greatest_step = 8;
/// The share of a step that a coefficient needs beyond a whole number to count as the next one.
constexpr double truncation = 0.6;

/// A row or column of numbers, each of which may be a whole row itself.
struct Lanes {
    float* first;
    std::size_t length, stride, lanes;
};

/// Adds to each second number, from `from` on, a multiple of the sum of its neighbours. A missing
/// neighbour is replaced by the other one.
void lift(const Lanes& line, std::size_t from, double factor) {
    const auto weight = static_cast<float>(factor);
    for (std::size_t i = from; i < line.length; i += 2) {
        const std::size_t before = i == 0 ? i + 1 : i - 1,
                          after = i + 1 < line.length ? i + 1 : i - 1;
        const float* a = line.first + before * line.stride;
        const float* b = line.first + after * line.stride;
        float* here = line.first + i * line.stride;
        for (std::size_t lane = 0; lane < line.lanes; ++lane)
            here[lane] += weight * (a[lane] + b[lane]);
    }
}

/// Transforms a line; its low half is then in front.
void analyse(const Lanes& line, Coefficients& room) {
    if (line.length < 2) return;
    for (std::size_t i = 0; i < 4; ++i) lift(line, 1 - i % 2, lifting[i]);
    room.resize(line.length * line.lanes);
    const std::size_t low = (line.length + 1) / 2;
    for (std::size_t i = 0; i < line.length; ++i) {
        const auto scale = static_cast<float>(i % 2 == 0 ? even_scale : 1 / even_scale);
        const std::size_t place = i % 2 == 0 ? i / 2 : low + i / 2;
        for (std::size_t lane = 0; lane < line.lanes; ++lane)
            room[place * line.lanes + lane] = scale * line.first[i * line.stride + lane];
    }
    for (std::size_t i = 0; i < line.length; ++i)
        std::copy_n(room.begin() + static_cast<std::ptrdiff_t>(i * line.lanes), line.lanes,
                    line.first + i * line.stride);
}

struct Size {
    std::size_t width, height;
    /// The size of the low part after one level.
    Size half() const { return {(width + 1) / 2, (height + 1) / 2}; }
};

int levels_of(Size size) {
    constexpr std::size_t smallest = 16;
    constexpr int most = 6;
    int levels = 0;
    for (; levels < most && std::min(size.width, size.height) >= smallest; ++levels)
        size = size.half();
    return levels;
}

void transform(Coefficients& plane, const Size& whole, int levels) {
    Coefficients room;
    Size size = whole;
    for (int level = 0; level < levels; ++level) {
        for (std::size_t y = 0; y < size.height; ++y)
            analyse({plane.data() + y * whole.width, size.width, 1, 1}, room);
        analyse({plane.data(), size.height, whole.width, size.width}, room);
        size = size.half();
    }
}

double logarithm(double value) {
    constexpr double most = 0x1p26;  // beyond, 16 bits have no number
    return value > 0 ? math::log2(1 + light_code_gain * std::min(value, most)) : 0;
}

/// The three planes of a picture, transformed.
void fill_planes(const Image& image, std::span<Coefficients> planes) {
    for (Coefficients& plane : planes) plane.resize(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Rgb& v = image.pixels[i];
        const double red = logarithm(v.r), green = logarithm(v.g), blue = logarithm(v.b);
        planes[0][i] = static_cast<float>((red + 2 * green + blue) / 4);
        planes[1][i] = static_cast<float>(red - blue);
        planes[2][i] = static_cast<float>(green - (red + blue) / 2);
    }
}

void append(std::string& bytes, double coefficient) {
    const double size = std::abs(coefficient) + 1 - truncation;
    const auto whole = static_cast<std::uint32_t>(std::min(size, 1e9));
    const std::uint32_t number = whole == 0 ? 0 : (coefficient < 0 ? 2 * whole - 1 : 2 * whole);
    constexpr std::uint32_t escape = 255;
    if (number < escape) {
        bytes += static_cast<char>(number);
        return;
    }
    bytes += static_cast<char>(escape);
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(number >> shift);
}

/// Appends the numbers of a part of a plane.
void append_part(std::string& bytes, const Coefficients& plane, std::size_t width, const Size& from,
                 const Size& to, double step) {
    for (std::size_t y = from.height; y < to.height; ++y)
        for (std::size_t x = from.width; x < to.width; ++x)
            append(bytes, plane[y * width + x] / step);
}

std::string packed(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string made(size, '\0');
    constexpr int effort = 9;
    if (compress2(reinterpret_cast<Bytef*>(made.data()), &size,
                  reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()),
                  effort) != Z_OK)
        throw std::bad_alloc();
    made.resize(size);
    return made;
}

class Coder {
public:
    Coder(std::span<const Image> images, int threads) : threads_(threads) {
        if (images.empty()) return;
        size_ = {static_cast<std::size_t>(images[0].width),
                 static_cast<std::size_t>(images[0].height)};
        levels_ = levels_of(size_);
        planes_.resize(3 * images.size());
        run_parallel(images.size(), threads, [&](std::size_t i) {
            const auto three = std::span(planes_).subspan(3 * i, 3);
            fill_planes(images[i], three);
            for (Coefficients& plane : three) transform(plane, size_, levels_);
        });
    }

    LightCode code(double step) const {
        std::vector<std::string> texts(planes_.size());
        run_parallel(planes_.size(), threads_, [&](std::size_t i) {
            texts[i] = numbers(planes_[i], i % 3 == 0 ? step : 2 * step);
        });
        std::string all;
        for (const std::string& text : texts) all += text;
        return {levels_, step, packed(all)};
    }

private:
    std::string numbers(const Coefficients& plane, double step) const {
        std::vector<Size> sizes{size_};
        for (int level = 0; level < levels_; ++level) sizes.push_back(sizes.back().half());
        std::string bytes;
        bytes.reserve(plane.size());
        const std::size_t width = size_.width;
        append_part(bytes, plane, width, {0, 0}, sizes.back(), step);
        for (std::size_t level = sizes.size() - 1; level > 0; --level) {
            const Size low = sizes[level], all = sizes[level - 1];
            append_part(bytes, plane, width, {low.width, 0}, {all.width, low.height}, step);
            append_part(bytes, plane, width, {0, low.height}, {low.width, all.height}, step);
            append_part(bytes, plane, width, low, all, step);
        }
        return bytes;
    }

    int threads_;
    Size size_{0, 0};
    int levels_ = 0;
    std::vector<Coefficients> planes_;
};

}  // namespace

LightCode light_code(std::span<const Image> images, double step, int threads) {
    return Coder(images, threads).code(step);
}

LightCode light_code_within(std::span<const Image> images, std::size_t most_bytes, int threads) {
    const Coder coder(images, threads);
    LightCode code = coder.code(finest_light_step);
    double too_fine = 0;
    // Bytes fall about as fast as the step grows, or slower.
    while (code.bytes.size() > most_bytes && code.step < greatest_step) {
        too_fine = code.step;
        const double excess =
            static_cast<double>(code.bytes.size()) / static_cast<double>(most_bytes);
        code = coder.code(
            std::min(greatest_step, code.step * std::clamp(std::sqrt(excess), 1.05, 4.0)));
    }
    constexpr int refinements = 3;
    for (int i = 0; i < refinements && too_fine > 0 && code.bytes.size() <= most_bytes; ++i) {
        LightCode finer = coder.code(std::sqrt(too_fine * code.step));
        if (finer.bytes.size() <= most_bytes)
            code = std::move(finer);
        else
            too_fine = finer.step;
    }
    return code;
}

}  // namespace candelabra
