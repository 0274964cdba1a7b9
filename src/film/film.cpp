// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/film.h"

#include "base/size_product.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <utility>

namespace candelabra {

void PixelSum::add(const Rgb& sample, bool subtracted, double exposure) {
    for (int i = 0; i < 3; ++i) {
        const auto channel = static_cast<std::size_t>(i);
        radiance[channel].add(subtracted ? -sample[i] : sample[i]);
        // A square root is close enough to a display's transfer function for weighing differences.
        const double light = sample[i] * exposure;
        const double shown = light > 0 ? std::sqrt(std::min(light, 1.0)) : 0;
        const auto units = static_cast<std::uint64_t>(shown * 0x1p20 + 0.5);
        display[channel] += units;
        display_squared[channel] += units * units;
    }
    ++samples;
    negative += subtracted ? 1 : 0;
}

void PixelSum::add(const PixelSum& other) {
    for (std::size_t i = 0; i < 3; ++i) {
        radiance[i].add(other.radiance[i]);
        display[i] += other.display[i];
        display_squared[i] += other.display_squared[i];
    }
    samples += other.samples;
    negative += other.negative;
    shadow_rays += other.shadow_rays;
}

Rgb PixelSum::mean() const {
    if (!(weight() > 0)) return Rgb(0);
    return Rgb(radiance[0].value(), radiance[1].value(), radiance[2].value()) / weight();
}

double PixelSum::variance(std::size_t channel) const {
    using Wide = ExactSum::Wide;
    const Wide sum = static_cast<Wide>(display[channel]);
    const Wide spread =
        static_cast<Wide>(samples) * static_cast<Wide>(display_squared[channel]) - sum * sum;
    const double n = samples;
    return static_cast<double>(spread) / (n * (n - 1)) * 0x1p-40;
}

double PixelSum::deviation() const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::sqrt(variance(i));
    return sum;
}

double PixelSum::variance_of_mean() const {
    if (samples < 2) return 0;
    return std::max({variance(0), variance(1), variance(2)}) / samples;
}

// Sums begin as pages of zeros, and are copied byte by byte.
static_assert(std::is_trivially_copyable_v<PixelSum> && std::is_trivially_copyable_v<ExactSum>);
static_assert(sizeof(PixelSum) % alignof(ExactSum) == 0);

std::size_t Film::bytes_of(int width, int height, std::size_t aovs) {
    return size_product(static_cast<std::size_t>(width), static_cast<std::size_t>(height),
                        sizeof(PixelSum) + aovs * sizeof(ExactSum));
}

Film::Film(int width, int height, std::size_t aovs)
    : Film(width, height, aovs, ZeroedPages(bytes_of(width, height, aovs))) {}

Film::Film(int width, int height, std::size_t aovs, ZeroedPages pages)
    : width_(width),
      height_(height),
      last_row_(height),
      count_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      extras_(aovs),
      pages_(std::move(pages)) {}

Film::Film(const Film& other) : Film(other.width_, other.height_, other.extras_) {
    keep_to_rows(other.first_row_, other.last_row_);
    if (count_ > 0) std::memcpy(pages_.data(), other.pages_.data(), pages_.size());
}

Film& Film::operator=(const Film& other) {
    if (this != &other) *this = Film(other);
    return *this;
}

void Film::keep_to_rows(int first, int last) {
    first_row_ = std::clamp(first, 0, height_);
    last_row_ = std::clamp(last, first_row_, height_);
}

void Film::add(std::size_t pixel, const Film& other) {
    pixels()[pixel].add(other.pixels()[pixel]);
    for (std::size_t i = 0; i < extras_; ++i) extra(pixel)[i].add(other.extra(pixel)[i]);
}

Image Film::image() const {
    Image image(width_, height_);
    each([&](std::size_t i) { image.pixels[i] = pixels()[i].mean(); });
    return image;
}

bool operator==(const Film& a, const Film& b) {
    if (a.width_ != b.width_ || a.height_ != b.height_ || a.extras_ != b.extras_) return false;
    const std::size_t sums = a.count_ * a.extras_;
    return std::ranges::equal(a.pixels(), b.pixels()) &&
           std::equal(a.sums(), a.sums() + sums, b.sums());
}

}  // namespace candelabra
