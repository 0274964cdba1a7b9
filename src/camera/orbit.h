// SPDX-License-Identifier: GPL-3.0-or-later
// A camera that somebody moves by hand: around a point, across the picture, and towards the point.
// The moves are kept apart from the camera that the scene gives, so that they outlive its changes.
#pragma once

#include "camera/camera.h"

#include <string>

namespace candelabra {

/// What the camera turns around lies `distance` before it, which is above 0.
struct Sight {
    Projection camera;
    double distance = 1;
};

class Orbit {
public:
    /// Around the point, in degrees: to the right of it and above it. It never goes over the top.
    void turn(const Sight& given, double right, double up);
    /// The camera and the point move, by shares of what is seen at the point from edge to edge.
    void pan(const Sight& given, double right, double up);
    /// The distance to the point is multiplied; of parallel rays, the size of the picture.
    void approach(double factor);
    void reset() { *this = Orbit(); }
    bool moved() const { return moved_; }

    /// The camera that the scene gives, moved.
    Sight place(const Sight& given) const;

private:
    double right_ = 0, up_ = 0;  ///< degrees
    double factor_ = 1;
    Vec3 shift_ = Vec3(0);  ///< of the point
    bool moved_ = false;
};

/// Whether the camera can be moved: one of meshes has no place of its own.
bool can_orbit(const Projection&);

/// The camera as a block of the language, without the pattern of its normal.
std::string camera_script(const Sight&);

}  // namespace candelabra
