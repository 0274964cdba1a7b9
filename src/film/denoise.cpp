// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/denoise.h"

#include "base/elementary.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace candelabra {

namespace {

/// Radii of the search window and of the compared patches, in pixels.
constexpr int reach = 7, patch = 1;
/// Factor on the variance by which squared differences are divided. The best of the values tried
/// for a room and a city with 4 samples.
constexpr double variance_unit = 0.64;
constexpr double albedo_deviation = 0.1;
constexpr double normal_unit = 0.2;
/// Relative difference in depth, per pixel of distance.
constexpr double depth_unit = 0.02;
/// Added to the albedo, so that the light of black surfaces is not divided by 0.
constexpr double min_albedo = 0.02;
/// A weight of exp(-no_weight) or less is treated as 0.
constexpr double no_weight = 16;

/// Added to divisors, so that equal values without variance do not divide by 0.
constexpr double same = 1e-10;

struct DenoisedPixel {
    Rgb light;            ///< divided by the albedo
    Rgb shown, variance;  ///< the same, compressed as for display, and the variance of that
    Rgb albedo;
    Vec3 normal;
    double depth;
};

/// Returns the difference of two pixels beyond that due to noise; negative if it is smaller.
double difference(const DenoisedPixel& p, const DenoisedPixel& q) {
    const Rgb apart = p.shown - q.shown;
    const Rgb explained = p.variance + min(p.variance, q.variance);
    const Rgb beyond =
        (apart * apart - explained) / (variance_unit * (p.variance + q.variance) + Rgb(same));
    return (beyond.r + beyond.g + beyond.b) / 3;
}

/// Returns the difference of their surfaces as a negative exponent of the weight.
double surface_difference(const DenoisedPixel& p, const DenoisedPixel& q, int steps) {
    const Rgb albedo = p.albedo - q.albedo, albedo2 = albedo * albedo;
    const Vec3 normal = p.normal - q.normal;
    double sum = (albedo2.r + albedo2.g + albedo2.b) / (2 * albedo_deviation * albedo_deviation) +
                 dot(normal, normal) / normal_unit;
    if (std::isinf(p.depth) != std::isinf(q.depth)) return no_weight;
    if (!std::isinf(p.depth))
        sum += std::abs(p.depth - q.depth) /
               (std::min(p.depth, q.depth) * depth_unit * (1 + steps) + same);
    return sum;
}

/// Filters some rows of the picture. Patches also use adjacent rows.
class DenoisedRows {
public:
    /// `parts`: also divided by the albedo.
    DenoisedRows(const std::vector<DenoisedPixel>& pixels, const std::vector<Image>& parts,
                 const Image& size, int top, int bottom)
        : pixels_(pixels),
          parts_(parts),
          width_(size.width),
          height_(size.height),
          top_(top),
          bottom_(bottom),
          first_(std::max(top - patch, 0)),
          last_(std::min(bottom + patch, size.height)),
          apart_(place(0, last_, first_)),
          across_(apart_.size()),
          sums_(place(0, bottom, top), Rgb(0)),
          sums_of_parts_(parts.size(), sums_),
          weights_(sums_.size(), 0) {}

    void add_all() {
        for (int dv = -reach; dv <= reach; ++dv)
            for (int du = -reach; du <= reach; ++du) {
                compare(du, dv);
                add(du, dv);
            }
    }

    Rgb mean(int x, int y) const {
        const std::size_t at = place(x, y, top_);
        return sums_[at] / weights_[at];
    }
    Rgb mean_of_part(std::size_t part, int x, int y) const {
        const std::size_t at = place(x, y, top_);
        return sums_of_parts_[part][at] / weights_[at];
    }

private:
    std::size_t place(int x, int y, int from) const {
        return static_cast<std::size_t>(y - from) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    const DenoisedPixel& pixel(int x, int y) const {
        return pixels_[place(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1), 0)];
    }

    /// Compares each pixel with the one at an offset, and averages the differences along rows.
    void compare(int du, int dv) {
        for (int y = first_; y < last_; ++y) {
            for (int x = 0; x < width_; ++x)
                apart_[place(x, y, first_)] = difference(pixel(x, y), pixel(x + du, y + dv));
            for (int x = 0; x < width_; ++x) {
                const int begin = std::max(x - patch, 0), end = std::min(x + patch, width_ - 1);
                double sum = 0;
                for (int k = begin; k <= end; ++k) sum += apart_[place(k, y, first_)];
                across_[place(x, y, first_)] = sum / (end - begin + 1);
            }
        }
    }

    void add(int du, int dv) {
        const int steps = std::max(std::abs(du), std::abs(dv));
        for (int y = top_; y < bottom_; ++y) {
            if (y + dv < 0 || y + dv >= height_) continue;
            for (int x = std::max(0, -du); x < std::min(width_, width_ - du); ++x) {
                double exponent = patch_difference(x, y);
                if (exponent >= no_weight && steps > 0) continue;
                const DenoisedPixel& other = pixel(x + du, y + dv);
                exponent += surface_difference(pixel(x, y), other, steps);
                if (exponent >= no_weight && steps > 0) continue;
                const double weight = steps > 0 ? math::exp(-exponent) : 1;
                const std::size_t at = place(x, y, top_);
                sums_[at] += weight * other.light;
                weights_[at] += weight;
                for (std::size_t k = 0; k < parts_.size(); ++k)
                    sums_of_parts_[k][at] += weight * parts_[k].at(x + du, y + dv);
            }
        }
    }

    /// Returns the mean difference of two patches, at least 0.
    double patch_difference(int x, int y) const {
        const int begin = std::max(y - patch, first_), end = std::min(y + patch, last_ - 1);
        double sum = 0;
        for (int k = begin; k <= end; ++k) sum += across_[place(x, k, first_)];
        return std::max(sum / (end - begin + 1), 0.0);
    }

    const std::vector<DenoisedPixel>& pixels_;
    const std::vector<Image>& parts_;
    int width_, height_;
    int top_, bottom_;  ///< the filtered rows
    int first_, last_;  ///< including adjacent rows
    std::vector<double> apart_, across_;
    std::vector<Rgb> sums_;
    std::vector<std::vector<Rgb>> sums_of_parts_;
    std::vector<double> weights_;
};

Rgb divisor(const NoisyPicture& noisy, std::size_t pixel) {
    return noisy.albedo.pixels[pixel] + Rgb(min_albedo);
}

std::vector<DenoisedPixel> pixels_of(const NoisyPicture& noisy) {
    std::vector<DenoisedPixel> pixels;
    pixels.reserve(noisy.light.pixels.size());
    for (std::size_t i = 0; i < noisy.light.pixels.size(); ++i) {
        const Rgb by = divisor(noisy, i);
        const Rgb reflected = noisy.light.pixels[i] - noisy.glow.pixels[i];
        const Rgb slope = Rgb(1) / (Rgb(1) + noisy.exposure * max(reflected, Rgb(0)));
        const Rgb light = reflected / by;
        pixels.push_back({light, light * slope,
                          noisy.variance.pixels[i] * slope * slope * slope * slope / (by * by),
                          noisy.albedo.pixels[i], vec3_of(noisy.normal.pixels[i]), noisy.depth[i]});
    }
    return pixels;
}

/// The share of a pixel's light that is filtered, per channel.
Rgb filtered_share(const NoisyPicture& noisy, std::size_t pixel) {
    const Rgb& light = noisy.light.pixels[pixel];
    const Rgb& glow = noisy.glow.pixels[pixel];
    Rgb share(1);
    for (int c = 0; c < 3; ++c)
        if (light[c] > 0) share[c] = std::clamp(1 - glow[c] / light[c], 0.0, 1.0);
    return share;
}

}  // namespace

QuietPicture denoised(const NoisyPicture& noisy, int threads) {
    const std::vector<DenoisedPixel> pixels = pixels_of(noisy);
    QuietPicture made{noisy.light, noisy.parts};
    std::vector<Image> divided = noisy.parts;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const Rgb filtered = filtered_share(noisy, i);
        for (std::size_t k = 0; k < divided.size(); ++k) {
            divided[k].pixels[i] *= filtered / divisor(noisy, i);
            made.parts[k].pixels[i] *= Rgb(1) - filtered;
        }
    }
    const Image& size = noisy.light;
    constexpr int rows_at_once = 16;
    const int blocks = (size.height + rows_at_once - 1) / rows_at_once;
    run_parallel(static_cast<std::size_t>(blocks), threads, [&](std::size_t block) {
        const int top = static_cast<int>(block) * rows_at_once,
                  bottom = std::min(top + rows_at_once, size.height);
        DenoisedRows rows(pixels, divided, size, top, bottom);
        rows.add_all();
        for (int y = top; y < bottom; ++y)
            for (int x = 0; x < size.width; ++x) {
                const Rgb by = noisy.albedo.at(x, y) + Rgb(min_albedo);
                made.light.at(x, y) = noisy.glow.at(x, y) + by * rows.mean(x, y);
                for (std::size_t k = 0; k < divided.size(); ++k)
                    made.parts[k].at(x, y) += by * rows.mean_of_part(k, x, y);
            }
    });
    return made;
}

}  // namespace candelabra
