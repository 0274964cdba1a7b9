// SPDX-License-Identifier: GPL-3.0-or-later
// The default texture and camera, which depend on the language version: from 3.8 on the pigment is
// white, `ambient` is 0 and the camera is as wide as the picture. Used by evaluate().
#pragma once

#include "reading/binder.h"

namespace candelabra {

class VersionDefaults {
public:
    explicit VersionDefaults(Binder& binder) : binder_(binder) {}

    /// Changes the binder's defaults to those of the version. After keep(), reports instead that
    /// they do not change; an unknown span or one of the library is not reported.
    void follow(double version, Span);
    /// To be called when `#default` changes them: from then on, versions do not.
    void keep() { kept_ = true; }

private:
    Binder& binder_;
    Handle<Texture> old_ = binder_.default_texture, modern_ = {};
    bool is_modern_ = false;
    bool kept_ = false;
};

}  // namespace candelabra
