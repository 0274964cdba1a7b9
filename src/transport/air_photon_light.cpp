// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/air_photon_light.h"

#include "base/running_sums.h"
#include "medium/transmittance.h"
#include "scattering/phase_function.h"

#include <span>
#include <vector>

namespace candelabra {

namespace {

/// Factor on the number of photons evaluated in homogeneous media, where evaluation is quick.
constexpr int choices_in_even_media = 4;

/// A photon whose ball the ray passes through.
struct Passed {
    const Photon* photon;
    double distance;
    Rgb power;  ///< colour of light times length
};

class AirGatherer {
public:
    AirGatherer(const World& world, const PhotonStretch& stretch, LightLedger& ledger)
        : scene_(world.pattern_scene()),
          stretch_(stretch),
          ledger_(ledger),
          choices_((homogeneous(stretch.media) ? choices_in_even_media : 1) * stretch.choices) {}

    std::size_t choices() const { return static_cast<std::size_t>(choices_); }

    Rgb of_all(std::span<const Passed> passed) {
        for (const Passed& each : passed) add(each, 1, 0);
        return sum_;
    }

    /// Light of a sample of the photons, chosen in proportion to their power, whose sums are given.
    Rgb of_some(std::span<const Passed> passed, std::span<const double> sums) {
        const double total = sums.back(), count = choices_;
        const double shift = uniform(stretch_.path.key, Purpose::photon_in_air);
        for (int i = 0; i < choices_; ++i) {
            const std::size_t found = drawn_share(sums, (i + shift) / count).index;
            add(passed[found], total / (count * weight_of(sums, found)), i);
        }
        return sum_;
    }

private:
    void add(const Passed& passed, double weight, int number) {
        const Ray& ray = stretch_.path.ray;
        const Rgb left = transmittance(
            stretch_.media, ray, {0, passed.distance}, scene_,
            stretch_.path.key.branched(Branch::medium, static_cast<std::uint32_t>(number)));
        const PhaseFunction phase(
            stretch_.media, ray.at(passed.distance), ray.direction, scene_,
            weight * left * passed.power,
            stretch_.path.scattered ? LightInAir::repeatedly_only : LightInAir::any);
        const Rgb seen = phase.evaluate(-Vec3(passed.photon->direction));
        sum_ += seen;
        ledger_.add_reflected(passed.photon->lamp, seen, stretch_.path.throughput);
    }

    PatternScene scene_;
    const PhotonStretch& stretch_;
    LightLedger& ledger_;
    int choices_;  ///< number of photons that are evaluated
    Rgb sum_ = Rgb(0);
};

}  // namespace

Rgb light_of_air_photons(const World& world, const AirPhotonMap& map, const PhotonStretch& stretch,
                         LightLedger& ledger) {
    std::vector<Passed> passed;
    std::vector<double> sums;
    double total = 0;
    map.along(stretch.path.ray, stretch.distance,
              [&](const Photon& photon, double distance, double away2) {
                  const Rgb power = air_photon_density(photon, away2) * rgb_of(photon.power);
                  const double size = max_abs_component(power);
                  if (!(size > 0)) return;
                  passed.push_back({&photon, distance, power});
                  sums.push_back(total += size);
              });
    if (passed.empty()) return Rgb(0);
    AirGatherer gatherer(world, stretch, ledger);
    return passed.size() <= gatherer.choices() ? gatherer.of_all(passed)
                                               : gatherer.of_some(passed, sums);
}

}  // namespace candelabra
