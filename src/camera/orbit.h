// SPDX-License-Identifier: GPL-3.0-or-later
// A camera moved interactively: around a point, across the picture, and towards the point. The
// moves are stored apart from the scene's camera, so that they outlive changes of it.
#pragma once

#include "camera/camera.h"

#include <string>

namespace candelabra {

/// A camera and the distance, above 0, of the point in front of it that it orbits.
struct Sight {
    Projection camera;
    double distance = 1;
};

class Orbit {
public:
    /// Turns around the point, in degrees to the right and upwards. It never passes over the top.
    void turn(const Sight& given, double right, double up);
    /// Moves the camera and the point, by fractions of the picture's width and height at the point.
    void pan(const Sight& given, double right, double up);
    /// Multiplies the distance to the point, or for parallel rays the size of the picture.
    void approach(double factor);
    void reset() { *this = Orbit(); }
    bool moved() const { return moved_; }

    /// Returns the scene's camera with the moves applied.
    Sight place(const Sight& given) const;

private:
    double right_ = 0, up_ = 0;  ///< degrees
    double factor_ = 1;
    Vec3 shift_ = Vec3(0);  ///< of the point
    bool moved_ = false;
};

/// Whether the camera can be moved: a mesh camera has no position of its own.
bool can_orbit(const Projection&);

/// The camera as a block of the language, without the pattern of its normal.
std::string camera_script(const Sight&);

}  // namespace candelabra
