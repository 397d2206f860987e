// SPDX-License-Identifier: GPL-3.0-or-later
// Places that need other lengths than asked.
#pragma once

#include <string>
#include <vector>

#include "brep/brep.h"
#include "core/ids.h"
#include "core/message.h"
#include "mesh/mesh.h"
#include "sizing/sizing_field.h"

namespace featuremesh {

enum class SizeReason {
    none,
    cannot_follow,  ///< elements are too long to follow the part
    boundary,       ///< tets cannot be made to meet the triangles there
    thin,           ///< a few tets without a volume to speak of remain
    folded          ///< 10-node tets would be folded, or nearly so
};

/// What found a place that needs other lengths asks for. Without lengths, nothing.
struct SizeRequest {
    SizeReason reason = SizeReason::none;
    std::vector<Entity> place;             ///< faces, or a solid
    std::vector<SizeSource> lengths = {};  ///< with which it may work, or get better
    bool is_empty() const { return lengths.empty(); }
};

/// Why all that is not kept was filled again, and with what.
struct Round {
    std::string reason;         ///< a word or two: narrow faces, cannot follow, boundary, thin elements, folded, small
                                ///< angles, details, kept elements
    std::vector<Entity> place;  ///< faces, or a solid; may be empty
    std::string change;         ///< what was done about it
    Message refusal;            ///< why there was no mesh; empty where one was only to get better
};

/// A filling is repeated so often at most, whatever the reasons, and so often in a row without a gain.
constexpr std::size_t most_rounds = 6, most_rounds_that_keep = 3, most_rounds_in_vain = 2;

/// For half the longest sides of at least one triangle, which is not as it should be.
SizeRequest for_triangles(const Mesh& mesh, const std::vector<TriangleId>& triangles, SizeReason reason);
/// Says that these lie the wrong way round on their faces.
Message turned_over(const Mesh& mesh, const std::vector<TriangleId>& turned);

/// The solids whose tets have a volume that is off by more than the share `tolerance`.
std::vector<SolidId> solids_off_volume(const Mesh& mesh, const Brep& brep, double tolerance);
/// For all surface triangles of one of them.
SizeRequest for_volume_of(const Mesh& mesh, const Brep& brep, SolidId solid);

}  // namespace featuremesh
