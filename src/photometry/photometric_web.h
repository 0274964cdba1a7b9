// SPDX-License-Identifier: GPL-3.0-or-later
// The luminous intensity of a luminaire by direction, from a table of two angles, as goniometers
// measure it. Tables are those of ANSI/IES LM-63: type C has its poles below and above, type A and
// type B have theirs at the sides of a beam.
//
// Directions are in the luminaire's own frame: z points up, x to horizontal angle 0 of type C (the
// plane C0 of EULUMDAT), and angles of type C increase counter-clockwise seen from above.
#pragma once

#include "base/vector.h"

#include <cstddef>
#include <vector>

namespace candelabra {

/// Which direction a pair of angles (V, H) means.
enum class WebType {
    c,  ///< (sin V cos H, sin V sin H, -cos V): V is 0 straight down, 180 straight up
    b,  ///< (cos H sin V, -sin H, -cos H cos V): down at V = H = 0; V turns about the y axis
    a   ///< (cos V cos H, -cos V sin H, sin V): along x at V = H = 0; V is the elevation
};

/// A direction in which a table has an intensity.
struct WebAngles {
    double vertical = 0, horizontal = 0;  ///< degrees
};

/// The table of a luminaire, with all factors of its file, and with what a symmetry leaves out.
class PhotometricWeb {
public:
    PhotometricWeb() = default;

    /// Angles in degrees, strictly increasing. `candela` has the intensities of all vertical angles
    /// for the first horizontal angle, then for the next. Preconditions: at least two of each
    /// angles; a table of type C goes once around, from H to H + 360, and both ends are equal.
    PhotometricWeb(WebType, std::vector<double> vertical, std::vector<double> horizontal,
                   std::vector<double> candela);

    WebType type() const { return type_; }
    const std::vector<double>& vertical() const { return vertical_; }
    const std::vector<double>& horizontal() const { return horizontal_; }

    /// Returns the intensity in candela, bilinear in the two angles; 0 outside the table. The
    /// direction need not have unit length.
    double intensity(const Vec3& direction) const;
    double intensity(const WebAngles&) const;

    /// Returns the luminous flux in lumens: the exact integral of intensity() over all directions.
    double flux() const;
    /// Returns the flux into directions below the horizontal, exact as well. Type C only.
    double flux_down() const;

    /// Returns the angles of the greatest intensity in the table, the first of several.
    WebAngles peak() const;
    double greatest() const { return intensity(peak()); }

    friend bool operator==(const PhotometricWeb&, const PhotometricWeb&) = default;

private:
    double at(std::size_t plane, std::size_t row) const {
        return candela_[plane * vertical_.size() + row];
    }
    double flux_between(double from, double to) const;

    WebType type_ = WebType::c;
    std::vector<double> vertical_, horizontal_;
    std::vector<double> candela_;
};

/// Returns the angles of a direction. For type C the horizontal angle is between 0 and 360.
WebAngles angles_of(WebType, const Vec3& direction);
/// Returns the direction of unit length. The inverse of angles_of().
Vec3 direction_of(WebType, const WebAngles&);

}  // namespace candelabra
