// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces bound which solids.
#pragma once

#include <vector>

#include "brep/brep.h"
#include "core/ids.h"

namespace featuremesh {

/// By solid, ascending.
inline std::vector<std::vector<FaceId>> faces_of_solids(const Brep& brep) {
    std::vector<std::vector<FaceId>> faces(brep.solid_count());
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        for (const SolidId s : brep.solids_beside(FaceId(f)))
            if (s.is_valid() && (faces[s.index()].empty() || faces[s.index()].back() != FaceId(f)))
                faces[s.index()].emplace_back(f);
    return faces;
}

/// By face: how many solids are beside it.
inline std::vector<char> counts_of_solids_beside(const Brep& brep) {
    std::vector<char> counts;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        const auto solids = brep.solids_beside(FaceId(f));
        counts.push_back(char(solids[0].is_valid() + solids[1].is_valid()));
    }
    return counts;
}

}  // namespace featuremesh
