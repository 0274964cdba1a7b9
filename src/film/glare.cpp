// SPDX-License-Identifier: GPL-3.0-or-later
#include "film/glare.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "base/fft.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

/// Mean wavelengths of the channels, in nanometres.
const Rgb wavelengths(611, 549, 465);
constexpr double middle_wavelength = 549;

/// Field of view in degrees for pictures whose camera is unknown.
constexpr double usual_field = 50;

/// Near the light itself, a pixel is the mean of this many points in each direction, because the
/// veil is steep within a pixel there.
constexpr int near_pixels = 3, places_in_near = 8;

/// Half width of a ray of the star, in pixels; real rays are far narrower.
constexpr double ray_width = 0.5;

/// Spencer et al.: parts of the eye's point spread function per solid angle, for an angle in
/// degrees.
double veil_density(double degrees) {
    constexpr double steep_share = 0.478, flat_share = 0.138;
    const double away = degrees + 0.02;
    return steep_share * 20.91 / (away * away * away) + flat_share * 72.37 / (away * away);
}

double halo_density(double degrees, double nanometres) {
    constexpr double ring_wavelength = 568;
    const double off = degrees - 3 * nanometres / ring_wavelength;
    return ring_wavelength / nanometres * math::exp(-off * off);
}

/// Sums a function over rows. Sums of rows are added in row order.
template <class Sum, class OfRow>
Sum sum_rows(int rows, int threads, const OfRow& of_row) {
    std::vector<Sum> sums(static_cast<std::size_t>(rows));
    run_parallel(sums.size(), threads,
                 [&](std::size_t row) { sums[row] = of_row(static_cast<int>(row)); });
    Sum all;
    for (const Sum& each : sums) all += each;
    return all;
}

double finite(double value) { return std::isfinite(value) ? value : 0; }

/// Returns two channels of the picture as real and imaginary parts, in the upper left corner of a
/// plane.
ComplexPlane picture_plane(const Image& image, std::size_t width, std::size_t height, int first,
                           int second) {
    ComplexPlane plane(width, height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Rgb& pixel = image.at(x, y);
            plane.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) = {
                finite(pixel[first]), second < 3 ? finite(pixel[second]) : 0};
        }
    return plane;
}

/// Returns the kernel around the upper left corner. The plane is periodic, so the other three
/// quadrants wrap around.
ComplexPlane kernel_plane(const GlareKernel& kernel, std::size_t width, std::size_t height,
                          int first, int second, int threads) {
    ComplexPlane plane(width, height);
    const int down = kernel.height() - 1, right = kernel.width() - 1;
    run_parallel(static_cast<std::size_t>(down) + 1, threads, [&](std::size_t dy) {
        for (int dx = -right; dx <= right; ++dx) {
            const Rgb share = kernel.at(dx, static_cast<int>(dy));
            const Complex both{share[first], second < 3 ? share[second] : 0};
            const std::size_t x =
                dx < 0 ? width - static_cast<std::size_t>(-dx) : static_cast<std::size_t>(dx);
            plane.at(x, dy) = both;
            // The kernel is point-symmetric.
            plane.at((width - x) % width, (height - dy) % height) = both;
        }
    });
    return plane;
}

/// Multiplies the spectra of two real pictures, packed into one complex plane, by a spectrum each.
/// Spectra of kernels are real because kernels are symmetric; both are packed into one complex
/// plane, too.
void multiply(ComplexPlane& pictures, const ComplexPlane& kernels) {
    for (std::size_t v = 0; v < pictures.height; ++v)
        for (std::size_t u = 0; u < pictures.width; ++u) {
            const std::size_t across = (pictures.width - u) % pictures.width,
                              down = (pictures.height - v) % pictures.height;
            if (down < v || (down == v && across < u)) continue;
            Complex &here = pictures.at(u, v), &there = pictures.at(across, down);
            const Complex a = here, b = {there.re, -there.im};
            const Complex one{(a.re + b.re) / 2, (a.im + b.im) / 2};
            const Complex other{(a.im - b.im) / 2, (b.re - a.re) / 2};
            const Complex factors = kernels.at(u, v);
            const Complex p{one.re * factors.re, one.im * factors.re},
                q{other.re * factors.im, other.im * factors.im};
            here = {p.re - q.im, p.im + q.re};
            there = {p.re + q.im, q.re - p.im};
        }
}

}  // namespace

GlareKernel::Parts& GlareKernel::Parts::operator+=(const Parts& other) {
    veil += other.veil;
    halo += other.halo;
    star += other.star;
    return *this;
}

GlareKernel::GlareKernel(const Glare& glare, int width, int height, int threads)
    : glare_(glare), width_(width), height_(height) {
    const double field = glare.field > 0 ? glare.field : usual_field;
    plane_ = width / 2.0 / math::tan(field / 2 * radians_per_degree);
    if (glare.blades < 3) glare_.star = 0;
    const int rays = glare.blades % 2 == 0 ? glare.blades : 2 * glare.blades;
    for (int i = 0; i < rays && glare_.star > 0; ++i) {
        const double turn = (glare.angle + 90 + 360.0 * i / rays) * radians_per_degree;
        rays_.emplace_back(math::cos(turn), -math::sin(turn));
    }
    const Parts all = sum_rows<Parts>(height, threads, [&](int dy) {
        Parts sum;
        // By symmetry, rows above equal the rows below.
        for (int dx = 1 - width_; dx < width_; ++dx) {
            const Parts parts = parts_at(dx, dy);
            sum += parts;
            if (dy > 0) sum += parts;
        }
        return sum;
    });
    scales_.veil = glare_.veil > 0 ? glare_.veil / all.veil : 0;
    if (glare_.halo > 0) scales_.halo = Rgb(glare_.halo) / all.halo;
    if (glare_.star > 0) scales_.star = Rgb(glare_.star) / all.star;
}

void GlareKernel::add_point(double dx, double dy, Parts& parts) const {
    const double squared = (dx * dx + dy * dy) / (plane_ * plane_);
    const double angle = math::atan(std::sqrt(squared)) / radians_per_degree;
    // Pixels far from the centre subtend a smaller solid angle.
    const double smaller = 1 / ((1 + squared) * std::sqrt(1 + squared));
    if (glare_.veil > 0) parts.veil += veil_density(angle) * smaller;
    for (int i = 0; i < 3 && glare_.halo > 0; ++i)
        parts.halo[i] += halo_density(angle, wavelengths[i]) * smaller;
    if (glare_.star > 0) add_star(dx, dy, angle, parts);
}

void GlareKernel::add_star(double dx, double dy, double angle, Parts& parts) const {
    double lit = 0;
    for (const Vec2& ray : rays_) {
        const double along = dx * ray.x + dy * ray.y;
        if (along < 0) continue;
        const double aside = (dx * ray.y - dy * ray.x) / ray_width;
        constexpr double far = 50;
        if (aside * aside < far) lit += math::exp(-aside * aside / 2);
    }
    if (lit == 0) return;
    for (int i = 0; i < 3; ++i) {
        const double off = angle * middle_wavelength / (glare_.length * wavelengths[i]);
        parts.star[i] += lit / (1 + off * off);
    }
}

GlareKernel::Parts GlareKernel::parts_at(int dx, int dy) const {
    Parts parts;
    if (std::max(std::abs(dx), std::abs(dy)) > near_pixels) {
        add_point(dx, dy, parts);
        return parts;
    }
    for (int j = 0; j < places_in_near; ++j)
        for (int i = 0; i < places_in_near; ++i)
            add_point(dx + (i + 0.5) / places_in_near - 0.5, dy + (j + 0.5) / places_in_near - 0.5,
                      parts);
    constexpr double share = 1.0 / (places_in_near * places_in_near);
    return {parts.veil * share, parts.halo * share, parts.star * share};
}

Rgb GlareKernel::at(int dx, int dy) const {
    const Parts parts = parts_at(dx, dy);
    const double stays = dx == 0 && dy == 0 ? 1 - glare_.share() : 0;
    return Rgb(stays + parts.veil * scales_.veil) + parts.halo * scales_.halo +
           parts.star * scales_.star;
}

Image spread(const Image& image, const GlareKernel& kernel, int threads) {
    Image result(image.width, image.height);
    const std::size_t width = fft_size(2 * static_cast<std::size_t>(image.width)),
                      height = fft_size(2 * static_cast<std::size_t>(image.height));
    // Red and green are transformed together, then blue alone.
    for (const int first : {0, 2}) {
        const int second = first + 1;
        ComplexPlane kernels = kernel_plane(kernel, width, height, first, second, threads);
        transform_forward(kernels, threads);
        ComplexPlane light = picture_plane(image, width, height, first, second);
        transform_forward(light, threads);
        multiply(light, kernels);
        kernels = {};
        transform_back(light, threads);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const Complex& here =
                    light.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y));
                result.at(x, y)[first] = here.re;
                if (second < 3) result.at(x, y)[second] = here.im;
            }
    }
    return result;
}

}  // namespace candelabra
