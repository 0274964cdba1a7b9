// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/make_picture.h"

#include "base/deep_stack.h"
#include "base/unless_ended.h"
#include "render/render.h"

#include <utility>

namespace candelabra {

namespace {

class PictureMaker {
public:
    PictureMaker(const SessionSettings& settings, const Listener& listener)
        : render_(settings.render),
          listener_(listener),
          session_(with_print(settings, listener), diagnostics_) {}

    std::optional<Picture> make() {
        const bool there = session_.read();
        if (!goes_on() || !there) return {};
        Scene scene = session_.evaluate();
        if (!goes_on()) return {};
        Picture picture;
        picture.gamma = scene.settings.assumed_gamma;
        picture.encoded = scene.gamma_handling;
        const Shot shot(session_.compile(std::move(scene), Session::Shutter::all_samples, true),
                        ShotSettings::of(render_));
        if (!goes_on() || !render(shot, picture)) return {};
        picture.files = session_.files();
        return picture;
    }

private:
    static SessionSettings with_print(SessionSettings settings, const Listener& listener) {
        settings.evaluation.print = listener.print;
        settings.evaluation.ended = listener.cancelled;
        return settings;
    }

    /// Reports new diagnostics. Returns whether to continue.
    bool goes_on() {
        const auto& all = diagnostics_.all();
        for (; told_ < all.size(); ++told_)
            if (listener_.diagnostic) listener_.diagnostic(all[told_], session_.sources());
        return !diagnostics_.failed() && !(listener_.cancelled && listener_.cancelled());
    }

    bool render(const Shot& shot, Picture& picture) {
        RenderHooks hooks;
        hooks.progress = listener_.progress;
        hooks.cancelled = hooks.ended = listener_.cancelled;
        RenderState state = begin_picture(render_, 0);
        const auto plan = plan_of(shot, render_, listener_.cancelled);
        if (!plan || !advance(*plan, state, picture.rays, hooks)) return false;
        picture.image = state.film.image();
        return true;
    }

    const RenderSettings& render_;
    const Listener& listener_;
    Diagnostics diagnostics_;
    std::size_t told_ = 0;
    Session session_;
};

}  // namespace

std::optional<Picture> make_picture(const SessionSettings& settings, const Listener& listener) {
    std::optional<Picture> picture;
    on_deep_stack(settings.evaluation.limits.stack_bytes, [&](std::size_t) {
        picture = unless_ended(listener.cancelled, [&] {
                      return PictureMaker(settings, listener).make();
                  }).value_or(std::nullopt);
    });
    return picture;
}

}  // namespace candelabra
