// SPDX-License-Identifier: GPL-3.0-or-later
// Which elements of an array are which after an edit.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "features/feature_tree.h"

namespace featuremesh {

/// An array lists one row after the other, so that all behind a row that got longer have other numbers. Where there are
/// more or fewer than before, those that stay where they were, from the first one, are the same; of one row whose
/// spacing changed their numbers tell.
class ArrayElements {
  public:
    ArrayElements(const FeatureTree& was, const FeatureTree& is);

    /// What the old tree's element of that name is called in the new one.
    VolumeName now(const VolumeName& element) const;

  private:
    std::map<std::string, std::map<std::int64_t, std::int64_t>>
        new_numbers_;  // of the arrays whose numbers do not tell
};

/// Does the volume belong to an element of an array, and not to a mirrored part or a link to one?
bool is_of_element(const Feature& feature, const std::vector<VolumeName>& copied_from);

}  // namespace featuremesh
