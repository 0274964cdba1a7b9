// SPDX-License-Identifier: GPL-3.0-or-later
// The web of a lamp in a scene: which file it comes from, and how it is turned. Two axes turn it.
#pragma once

#include "base/handle.h"
#include "base/transform.h"
#include "photometry/lamp_tilt.h"
#include "photometry/photometric_web.h"

#include <optional>
#include <string>

namespace candelabra {

/// The content of a photometric file, which all lamps of the file share.
struct LoadedWeb {
    Handle<PhotometricWeb> web = {};  ///< null: there is no file
    Handle<LampTilt> tilt = {};       ///< null: its light is the same in any position

    friend bool operator==(const LoadedWeb&, const LoadedWeb&) = default;
};

/// Fields of lamps in the language by which they name and turn a web.
struct WebPlace : LoadedWeb {
    std::string ies = {}, ldt = {};  ///< name of the file, in one of them
    std::optional<int> profile = {};  ///< the file is a model, of which this is the number of one
    int lamp_set = 1;                ///< of EULUMDAT, from 1
    double multiplier = 1;           ///< of the file's intensities
    Vec3 aim = Vec3(0, -1, 0);       ///< where the web's straight down (gamma 0) leads
    Vec3 c0 = Vec3(1, 0, 0);         ///< where the plane C0 lies; its part along `aim` is left out
    bool mirrored = false;           ///< the planes C90 and C270 are exchanged

    /// Candela of the file in the scene's numbers: see LightUnits::intensity(). It has the
    /// multiplier.
    double per_candela = 1;

    const std::string& file() const { return ies.empty() ? ldt : ies; }
    friend bool operator==(const WebPlace&, const WebPlace&) = default;
};

/// Turns the axes with a lamp. A transformation that stretches the lamp only turns its web, and one
/// that mirrors the lamp mirrors its web.
void turn(WebPlace&, const Transform&);

/// Factor on the intensities of the file as the luminaire is tilted: by the angle between `aim` and
/// -y, if the file has factors that follow it. Precondition: has_axes().
double tilt_factor(const WebPlace&);

/// Whether `aim` and `c0` are two directions.
bool has_axes(const WebPlace&);

/// A web in the space of the scene.
class AimedWeb {
public:
    /// Preconditions: there is a web, and has_axes().
    explicit AimedWeb(const WebPlace&);
    /// The same as of a place with the web of another one, which tells what does not depend on the
    /// axes.
    AimedWeb(const AimedWeb&, const WebPlace&);

    /// Intensity in candela in a direction away from the lamp, which need not have unit length.
    double intensity(const Vec3& direction) const { return web_->intensity(own(direction)); }
    /// The direction in the web's own frame of one in the scene.
    Vec3 own(const Vec3& direction) const {
        return {dot(direction, x_), dot(direction, y_), dot(direction, z_)};
    }
    /// The greatest intensity in candela.
    double greatest() const { return greatest_; }
    /// Share of the greatest intensity; 0 everywhere if the web is dark.
    double share(const Vec3& direction) const {
        return greatest_ > 0 ? intensity(direction) / greatest_ : 0;
    }
    /// The direction in the scene of one in the web's own frame.
    Vec3 towards(const Vec3& own) const { return own.x * x_ + own.y * y_ + own.z * z_; }
    const PhotometricWeb& web() const { return *web_; }
    /// The unit direction of `aim`.
    Vec3 aim() const { return -z_; }
    /// Half angles, in radians, of cones around the aim: outside of `dark` there is no light, and
    /// outside of `bright` less than half of the greatest intensity.
    double dark() const { return dark_; }
    double bright() const { return bright_; }

    friend bool operator==(const AimedWeb&, const AimedWeb&) = default;

    const Handle<PhotometricWeb>& shared_web() const { return web_; }

private:
    void set_axes(const WebPlace&);

    Handle<PhotometricWeb> web_;
    /// The axes of the web's own frame (photometric_web.h), unit.
    Vec3 x_ = Vec3(0), y_ = Vec3(0), z_ = Vec3(0);
    double greatest_ = 0;
    double dark_ = 0, bright_ = 0;
};

}  // namespace candelabra
