// SPDX-License-Identifier: GPL-3.0-or-later
// Which faces bound which solids.
#pragma once

#include <vector>

#include "brep/brep.h"

namespace featuremesh {

/// By solid, ascending.
inline std::vector<std::vector<FaceId>> faces_of_solids(const Brep& brep) {
    std::vector<std::vector<FaceId>> faces(brep.solid_count());
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        for (const SolidId s : brep.sides_of(FaceId(f)))
            if (s.is_valid() && (faces[s.index()].empty() || faces[s.index()].back() != FaceId(f)))
                faces[s.index()].emplace_back(f);
    return faces;
}

/// By face: on how many of its sides there is a solid.
inline std::vector<char> counts_of_sides(const Brep& brep) {
    std::vector<char> counts;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        const auto sides = brep.sides_of(FaceId(f));
        counts.push_back(char(sides[0].is_valid() + sides[1].is_valid()));
    }
    return counts;
}

}  // namespace featuremesh
