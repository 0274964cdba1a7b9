// SPDX-License-Identifier: GPL-3.0-or-later
// The path of a photon from its lamp to the surfaces and media that show it: straight to its
// target, through clear surfaces in between, and then as mirrors and glasses direct it.
#pragma once

#include "base/rgb.h"
#include "transport/layer_stack.h"
#include "transport/photon_map.h"
#include "transport/photon_shooter.h"

#include <vector>

namespace candelabra {

class PhotonPaths {
public:
    explicit PhotonPaths(const Shot&);

    /// Adds the photon at each surface on its path that shows it, and at some points of its
    /// segments through media if the scene wants that. `share` is a factor on its power.
    void follow(const PhotonShot&, const Key&, double share, std::vector<Photon>&) const;

private:
    struct Journey;
    Rgb left_after(const Journey&, double distance, bool ends) const;
    bool pass(Journey&, const Vertex&, const Ray&) const;
    bool scatter(Journey&, const Vertex&, const Key&) const;
    bool go_on(Journey&, const Vertex&, const Layers&) const;
    bool is_refracted(const Journey&, const PhotonSurface&) const;
    bool is_reflected(const Journey&, const PhotonSurface&) const;
    void deposit(const Journey&, const Vertex&, std::vector<Photon>&) const;
    void deposit_in_air(const Journey&, double distance, std::vector<Photon>&) const;
    bool reaches(const Journey&, const Material&) const;
    bool answers(const Vertex&) const;

    const World& world_;
    const Box& near_;  ///< see Shot
    ShadingRules rules_;
    int max_surfaces_;
    double min_weight_;
    int places_in_air_ = 0;  ///< along each segment through media
};

}  // namespace candelabra
