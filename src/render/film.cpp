// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film.h"

#include <cmath>

void PixelSum::add(const Vec3& sample) {
    radiance += sample;
    // A square root is near enough to a display's transfer curve to weigh differences by.
    const Vec3 clipped = glm::clamp(sample, Vec3(0), Vec3(1));
    const Vec3 shown(std::sqrt(clipped.x), std::sqrt(clipped.y), std::sqrt(clipped.z));
    display += shown;
    display_squared += shown * shown;
    ++samples;
}

double PixelSum::deviation() const {
    const double n = samples;
    const Vec3 variance = glm::max((display_squared - display * display / n) / (n - 1), Vec3(0));
    return std::sqrt(variance.x) + std::sqrt(variance.y) + std::sqrt(variance.z);
}

Film::Film(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

Image Film::image() const {
    Image image(width_, height_);
    for (std::size_t i = 0; i < pixels_.size(); ++i)
        if (pixels_[i].samples > 0)
            image.pixels[i] = pixels_[i].radiance / static_cast<double>(pixels_[i].samples);
    return image;
}
