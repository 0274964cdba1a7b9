// SPDX-License-Identifier: GPL-3.0-or-later
// Photons where they have come to surfaces: each lights a small disc around it. (In the air:
// see air_photons.h.)
#pragma once

#include "transport/photon_tree.h"

namespace candelabra {

/// The share of its power per area that a photon gives a point: densest in the middle of its disc
/// (Epanechnikov's kernel). 0 outside, and where the surface at the point, which has that normal,
/// is another one.
double photon_density(const Photon&, const Vec3& point, const Vec3& normal);

class PhotonMap {
public:
    PhotonMap() = default;
    /// Sets the radii: where more photons have come they are smaller.
    PhotonMap(std::vector<Photon>, const DiscRule&);

    /// In an order that depends on them only.
    const std::vector<Photon>& photons() const { return tree_.photons(); }

    /// Calls use(photon) for those whose disc may hold the point, always in the same order.
    template <class Use>
    void around(const Vec3& point, const Use& use) const {
        tree_.walk([&](const Box& box) { return contains(box, point); },
                   [&](const Photon& photon) {
                       const Vec3 offset = point - photon.position;
                       const double radius = photon.radius;
                       if (dot(offset, offset) < radius * radius) use(photon);
                   });
    }

private:
    PhotonTree tree_;
};

}  // namespace candelabra
