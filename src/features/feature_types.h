// SPDX-License-Identifier: GPL-3.0-or-later
// What FreeCAD's types mean: the one table.
#pragma once

#include <string>
#include <vector>

#include "features/feature_tree.h"
#include "features/raw_document.h"

namespace featuremesh {

/// How a record of a type turns into a feature.
enum class Kind {
    container,      ///< passes on the result of one of its members
    chain_step,     ///< its own volume added to or removed from the shape before
    chain_change,   ///< changes the shape before it in place: fillets, drafts, hollowing
    chain_pattern,  ///< repeats other steps
    boolean,        ///< combines the results of its operands
    copy,           ///< another object's shape, perhaps elsewhere
    leaf,           ///< its shape is its volume
    reference       ///< sketches, datums and whatever else has no volume
};

struct TypeMeaning {
    Kind kind = Kind::leaf;
    Role role = Role::opaque;
    Effect effect = Effect::adds;
    Combination combination = Combination::volumes;
    /// Link properties that hold the shape before, the operands or the source, the first that is set counts.
    std::vector<std::string> sources;
    /// Link properties that hold the second operands, all of them.
    std::vector<std::string> tools;
    bool at_centres = false;  ///< made at the centres of its sketch's circles, however large those are
};

/// The meaning of a record's type and proxy; an unknown type is an opaque leaf.
TypeMeaning meaning_of(const RawRecord& record);

}  // namespace featuremesh
