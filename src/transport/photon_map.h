// SPDX-License-Identifier: GPL-3.0-or-later
// Photons on surfaces: each lights a small disc around it. (In the air: see air_photons.h.)
#pragma once

#include "transport/photon_tree.h"

namespace candelabra {

/// Fraction of a photon's power per area that arrives at a point, by Epanechnikov's kernel: it is
/// greatest in the centre of the photon's disc. 0 outside the disc, and where the surface at the
/// point, which has that normal, is another one.
double photon_density(const Photon&, const Vec3& point, const Vec3& normal);

class PhotonMap {
public:
    PhotonMap() = default;
    /// Sets the radii, which are smaller where photons are denser.
    PhotonMap(std::vector<Photon>, const DiscRule&);

    /// In an order that depends only on the photons.
    const std::vector<Photon>& photons() const { return tree_.photons(); }

    /// Calls use(photon) for each photon whose disc may contain the point, always in the same
    /// order.
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
