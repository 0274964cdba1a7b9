// SPDX-License-Identifier: GPL-3.0-or-later
// The integrators, as alternatives of a variant. The scene's settings choose one
// (method/settings.h).
#pragma once

#include "base/rgb.h"
#include "transport/path_traced.h"
#include "transport/povray.h"

#include <concepts>
#include <utility>
#include <variant>

namespace candelabra {

/// The interface of every integrator. Each job has its own: it keeps scratch memory and counts
/// rays.
template <class T>
concept IntegratorKind = std::constructible_from<T, const Shot&, const Tracing&> &&
    requires(T& integrator, const T& asked, const Ray& ray, const WhiteElement& element,
             const Key& key) {
    // Radiance along a camera ray: an unbiased estimate, and a pure function of ray and key.
    { integrator.radiance(ray, key) } -> std::same_as<Rgb>;
    // The same for what a white element shows.
    { integrator.element_radiance(element, key) } -> std::same_as<Rgb>;
    { integrator.ledger() } -> std::same_as<LightLedger&>;
    { asked.ledger() } -> std::same_as<const LightLedger&>;
    { asked.clear() } -> std::same_as<double>;  // share of the last sample that is clear
    { asked.cut() } -> std::same_as<bool>;      // whether the last sample is incomplete
    asked.prepare(std::uint32_t{});  // builds the sent light for a sample, with several threads
};

class Integrator {
public:
    /// The shot must outlive this.
    Integrator(const Shot& shot, const Tracing& wanted) : built_(built(shot, wanted)) {}

    Rgb radiance(const Ray& ray, const Key& key) {
        return std::visit([&](auto& built) { return built.radiance(ray, key); }, built_);
    }
    Rgb element_radiance(const WhiteElement& element, const Key& key) {
        return std::visit([&](auto& built) { return built.element_radiance(element, key); },
                          built_);
    }
    LightLedger& ledger() {
        return std::visit([](auto& built) -> LightLedger& { return built.ledger(); }, built_);
    }
    const LightLedger& ledger() const {
        return std::visit([](const auto& built) -> const LightLedger& { return built.ledger(); },
                          built_);
    }
    double clear() const {
        return std::visit([](const auto& built) { return built.clear(); }, built_);
    }
    bool cut() const {
        return std::visit([](const auto& built) { return built.cut(); }, built_);
    }
    void prepare(std::uint32_t sample) const {
        std::visit([&](const auto& built) { built.prepare(sample); }, built_);
    }

private:
    using Built = std::variant<PovRayIntegrator, PathTracedIntegrator>;

    /// Makes the integrator of the settings, in the order of IntegratorSettings.
    static Built built(const Shot& shot, Tracing wanted) {
        if (!wanted.sent) wanted.sent = SentLight::of(shot, 0, 1);
        if (std::holds_alternative<PathTraced>(shot.world->rules.settings.integrator))
            return PathTracedIntegrator(shot, wanted);
        return PovRayIntegrator(shot, wanted);
    }

    Built built_;
};
static_assert(IntegratorKind<PovRayIntegrator> && IntegratorKind<PathTracedIntegrator> &&
              IntegratorKind<Integrator>);

}  // namespace candelabra
