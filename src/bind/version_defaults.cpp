// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/version_defaults.h"

#include "text/message.h"

namespace candelabra {

namespace {

Handle<Texture> modern_texture() {
    Texture made;
    made.pigment.colour.rgb = Rgb(1);
    made.finish.ambient = Rgb(0);
    return make_handle<Texture>(std::move(made));
}

}  // namespace

void VersionDefaults::follow(double version, Span span) {
    const bool modern = version >= modern_version;
    if (modern == is_modern_) return;
    Evaluator& evaluator = binder_.evaluator;
    if (kept_) {
        if (!span.known() || evaluator.in_library(span)) return;
        evaluator.report(warning(Fault::no_effect, span,
                                 message("this `#version` does not change the default texture and "
                                         "camera, which a `#default` has fixed")));
        return;
    }
    if (modern && !modern_) modern_ = modern_texture();
    is_modern_ = modern;
    binder_.default_texture = modern ? modern_ : old_;
    const RunFacts& facts = evaluator.facts();
    const double aspect =
        modern ? static_cast<double>(facts.image_width) / facts.image_height : View().aspect;
    std::visit([&](View& view) { view.aspect = aspect; }, binder_.default_camera.camera);
}

}  // namespace candelabra
