// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in mesh { } in the place of triangles: a file, an object that becomes a mesh, a hull.
// Called by the reader of objects.
#pragma once

#include "bind/object_draft.h"
#include "meshing/library.h"

namespace candelabra {

class ModelReader : public SimpleReader {
public:
    /// Both outlive the reader. It takes nothing unless the block is a mesh.
    ModelReader(OpenBlock&, ObjectDraft&, bool is_mesh);

    bool take(const Element&);
    void add_words(WordList&) const;

    /// The mesh that is asked for. Nothing: the triangles are all that there is, or something has
    /// been reported.
    std::optional<Mesh> made(const TriangleMesh&);

private:
    /// The parts of a convex_hull.
    struct Hull {
        std::vector<Vec3> points;
        std::vector<ObjectHandle> objects;
    };

    void take_object(const Element&);
    void read_hull(const Element&);
    void wrong(const std::string& why);
    /// What the mesh is made of; nothing after a report.
    std::optional<Polyhedron> source(const TriangleMesh&, const Polyhedra*);
    /// False after a report.
    bool refine(Polyhedron&, int steps, const Polyhedra*);

    OpenBlock& block_;
    ObjectDraft& draft_;
    bool is_mesh_;
    ObjectHandle object_;
    std::optional<Hull> hull_;
    PolyhedronLook look_;  ///< of a file
    Span span_;            ///< of the object or hull
};

}  // namespace candelabra
