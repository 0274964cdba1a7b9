// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photons.h"

#include "base/elementary.h"
#include "base/parallel.h"

#include <algorithm>
#include <functional>

namespace candelabra {

namespace {

/// The squared radius is proportional to the generation's number to the power of alpha - 1. With
/// this value the error of the mean falls fastest.
constexpr double alpha = 2.0 / 3;
/// Number of generations kept in memory; others are made again on request.
constexpr std::size_t max_generations =
    Photons::single_samples + Photons::samples_at_once / Photons::shared_samples + 4;
/// Number of photons that one thread follows at a time.
constexpr std::uint32_t batch = 2048;
/// Radius of discs where next to no photons arrive, as a fraction of the target's radius.
constexpr double disc_of_target = 0.1;
/// Number of photons wanted in a ball in the air, as a fraction of the number wanted in a disc, and
/// its minimum: a camera ray passes through many balls.
constexpr double wanted_in_air = 0.6, min_in_air = 8;

}  // namespace

std::shared_ptr<Photons> photons_of(const Shot& shot, int seed, int threads) {
    return shot.world->photon_targets.empty() ? nullptr
                                              : std::make_shared<Photons>(shot, seed, threads);
}

Photons::Photons(const Shot& shot, int seed, int threads)
    : world_(*shot.world),
      shooter_(shot),
      paths_(shot),
      count_(shooter_.count()),
      seed_(mix(static_cast<std::uint64_t>(seed))),
      threads_(threads),
      generations_(max_generations) {}

/// Returns all photons of a random stream, in the order in which they are shot.
std::vector<Photon> Photons::shot(std::uint32_t count, std::uint64_t stream) const {
    return sent_in_batches<Photon>(
        count, batch, threads_,
        [&](std::uint32_t first, std::uint32_t last, std::vector<Photon>& found) {
            shoot(first, last, count, stream, found);
        });
}

/// Shoots photons `first` to before `last` of `count`. Each aim gets a contiguous range, so that
/// the photons of one aim are well distributed points.
void Photons::shoot(std::uint32_t first, std::uint32_t last, std::uint32_t count,
                    std::uint64_t stream, std::vector<Photon>& found) const {
    const auto& aims = shooter_.aims();
    if (aims.empty()) return;
    const double step = shooter_.weight() / count;
    const double offset = uniform({stream, 0, 0, 0}, Purpose::photon_offset);
    const auto first_of = [&](double weight) {
        return static_cast<std::uint32_t>(
            std::clamp<double>(std::ceil(weight / step - offset), 0, count));
    };
    auto aim =
        std::ranges::upper_bound(aims, (first + offset) * step, {}, &PhotonShooter::Aim::until);
    for (std::uint32_t i = first; i < last; ++i) {
        const double place = (i + offset) * step;
        while (aim != aims.end() && aim->until <= place) ++aim;
        if (aim == aims.end()) return;
        const auto number = static_cast<std::uint32_t>(aim - aims.begin());
        const Key key{stream, i - first_of(aim->until - aim->weight), number, 0};
        const auto shot = shooter_.shoot(*aim, key);
        // The expected number of photons of this aim is aim->weight / step.
        if (shot) paths_.follow(*shot, key, step / aim->weight, found);
    }
}

PhotonMaps Photons::made(std::uint32_t number) const {
    const PhotonSettings& settings = world_.rules.settings.photons;
    const DiscRule rule{std::fmax(settings.gather_most, 1),
                        math::pow(number + 1.0, 0.5 * (alpha - 1)), settings.radius,
                        disc_of_target * world_.photon_targets.front().radius};
    DiscRule in_air = rule;
    in_air.wanted = std::fmax(wanted_in_air * rule.wanted, min_in_air);
    in_air.radius = settings.media_radius;
    std::vector<Photon> all = shot(count_, mix(seed_ ^ mix(number + 1)));
    const auto first = std::stable_partition(all.begin(), all.end(), std::not_fn(&Photon::in_air));
    std::vector<Photon> rest(first, all.end());
    all.erase(first, all.end());
    return {PhotonMap(std::move(all), rule), AirPhotonMap(std::move(rest), in_air)};
}

std::shared_ptr<const PhotonMaps> Photons::generation(std::uint32_t number) {
    return generations_.get(number, [&] { return made(number); });
}

}  // namespace candelabra
