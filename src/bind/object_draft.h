// SPDX-License-Identifier: GPL-3.0-or-later
// An object while its block is read: what it is made of, how it looks, what has happened to it
// since. Called by the readers of objects; a declared object that is only moved shares all that it
// holds with the one that was declared.
#pragma once

#include "bind/textures.h"
#include "bind/transforms.h"

namespace candelabra {

/// What light_group { } says beside its lights and objects.
struct GroupSettings {
    bool global_lights = false;

    static const ItemInfo vocabulary;
};

/// What an object is made of and how it looks, while its block is read.
struct ObjectDraft {
    explicit ObjectDraft(Binder& binder) : binder(binder), texture(binder.default_texture) {}

    Binder& binder;
    ObjectHandle made = binder.pool.make();  ///< its form; the rest is put in by finished()
    /// What a declared name stands for; its form is not copied before it has to be.
    ObjectHandle declared;
    Switches switches;
    Switches declared_switches;
    TextureDraft texture;
    bool textured = false;    ///< there is a texture that is the object's own
    bool retextured = false;  ///< and this block has given or changed it
    bool furnished = false;   ///< this block has given or changed the interior
    Clipping clipping;        ///< where they are now
    bool clipped = false;     ///< this block has given some
    std::vector<Handle<Texture>> part_textures;
    Handle<Texture> interior_texture;  ///< null: as outside
    Handle<Transform> movement;        ///< since the form came; null: none
    bool constant_movement = true;     ///< the text says the same each time
    bool has_form = false;
    bool modified = false;
    bool cutaway = false;  ///< parts without a texture show what they cut through

    /// The form has come, but for itself: what else there is of the object.
    void take(const Object&);
    /// Transforms all that has come so far, and nothing that comes later.
    void move(const Movement&);
    /// A shape of which the renderer knows only parts: a cone that is crossed.
    void divide_form();
    /// The object as it is now; nobody else has it, unless it is the same as a declared one. The
    /// draft is used up.
    ObjectHandle finished(Span);

private:
    /// Only moved: so a union need not be copied, and a million of them cost little.
    bool only_moved() const {
        return !retextured && !furnished && !clipped && switches == declared_switches;
    }
};

/// `inverse`, which swaps inside and outside each time it is said.
class InversionReader : public SimpleReader {
public:
    explicit InversionReader(ObjectDraft& draft) : draft_(draft) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::word || element.word != "inverse"_word) return false;
        draft_.switches.inverse = !draft_.switches.inverse;
        return true;
    }

private:
    ObjectDraft& draft_;
};

/// All lights inside that light more than a group there, in the space around the object.
void append_lights(const Object&, std::vector<PlacedLight>&);

/// The same for an object in another one. A light group keeps only those that are not in unions.
void take_lights(const Object& part, Union& whole);

/// Notes that the spheres of rows are parts of the union that the rows are in.
void nest_rows(Object& whole);

/// A declared object as an object of its own, which shares what the declared one holds.
ObjectHandle another(const ObjectHandle&);

/// A declared object as a part of another one; it may share all with the declared one.
ObjectHandle as_part(const ObjectHandle&);

/// A light source as an object.
ObjectHandle as_object(PlacedLight);

/// Whether all parts of an object may be looked at, as cutting does; otherwise the block is broken.
bool may_be_cut(OpenBlock&, const Object&);

/// Reports that objects are nested too deeply, and stops. Null.
ObjectHandle too_deep(Binder&, const Element&);

}  // namespace candelabra
