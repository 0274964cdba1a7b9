// SPDX-License-Identifier: GPL-3.0-or-later
// A scene while its blocks are read; adds their results to it. Used by the readers in the table of
// blocks.
#pragma once

#include "bind/settings.h"
#include "reading/binder.h"

namespace candelabra {

class SceneContent {
public:
    /// Both arguments outlive this object.
    SceneContent(Binder& binder, Scene& scene) : binder(binder), scene(scene) {}

    Binder& binder;
    Scene& scene;
    GivenSettings given;

    /// Gives the object the default texture in force at the end of its statement.
    void add(ObjectHandle);
    void add(const PlacedLight&);
    /// Adds the camera that the block describes; warns if the scene has one already by another
    /// statement: the macros of screen.inc make theirs again.
    void add(const DeclaredCamera&, const Element& block);
    /// Sets the camera of the scene.
    void show(const DeclaredCamera&);

private:
    Span camera_at_;  ///< of the last one's keyword
};

}  // namespace candelabra
