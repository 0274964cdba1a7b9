// SPDX-License-Identifier: GPL-3.0-or-later
// The way of a photon from its lamp to what shows it, which are surfaces and the air: straight to
// its target, past what is clear before it, and then as mirrors and glasses send it.
#pragma once

#include "transport/layer_stack.h"
#include "transport/photon_map.h"
#include "transport/photon_shooter.h"

#include <vector>

namespace candelabra {

class PhotonPaths {
public:
    explicit PhotonPaths(const World&);

    /// Adds the photon where it comes to a surface that shows it; it may come to several. So also
    /// at some points of its ways through media, if the scene wants that. `share`: by what its
    /// power is multiplied.
    void follow(const PhotonShot&, const Key&, double share, std::vector<Photon>&) const;

private:
    struct Journey;
    /// A way on from a surface.
    struct Way {
        Vec3 share = Vec3(0);
        Shading shading = {};
        bool mirrors = false;
    };
    using Ways = ShortList<Way, 4>;

    void pass_media(PathState&, double distance) const;
    bool pass(Journey&, const Vertex&, const Ray&) const;
    bool scatter(Journey&, const Vertex&, const Key&) const;
    bool choose(Journey&, const Vertex&, std::span<const Layer>) const;
    bool go_behind(PathState&, const Vertex&, const LayerStack&) const;
    bool is_refracted(const Journey&, const PhotonSurface&) const;
    bool is_reflected(const Journey&, const PhotonSurface&) const;
    void deposit(const Journey&, const Vertex&, std::vector<Photon>&) const;
    void deposit_in_air(const Journey&, double distance, std::vector<Photon>&) const;
    bool answers(const Vertex&) const;

    const World& world_;
    ShadingRules rules_;
    int max_surfaces_;
    double min_weight_;
    int places_in_air_ = 0;  ///< of each way through media
};

}  // namespace candelabra
