// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/copied_volumes.h"

#include <algorithm>
#include <gp_Ax2.hxx>

#include "brep/occt_geometry.h"
#include "brep/same_solids.h"
#include "core/geometry.h"
#include "features/pattern_placements.h"

namespace featuremesh {

namespace {

using Placements = std::vector<gp_Trsf>;

using Volumes = std::vector<FeatureVolume>;

void append(Volumes& volumes, const Volumes& more, Effect step) {
    for (FeatureVolume volume : more) {
        volume.step = step;
        volumes.push_back(std::move(volume));
    }
}

bool only_adds(const Volumes& volumes) {
    return std::all_of(volumes.begin(), volumes.end(), [](const FeatureVolume& v) { return v.step == Effect::adds; });
}

/// Appends an operand as one more step; false when it is no union of volumes.
bool append_operand(Volumes& volumes, const Volumes& operand, Combination how) {
    if (!only_adds(operand)) return false;
    switch (how) {
        case Combination::fuse:
            return append(volumes, operand, Effect::adds), true;
        case Combination::cut:
            return append(volumes, operand, Effect::removes), true;
        case Combination::common:
            return operand.size() == 1 && (append(volumes, operand, Effect::keeps_only), true);
        default:
            return false;
    }
}

std::optional<Vec3> vector_of(const RawRecord& record, const std::string& name) {
    Vec3 v;
    for (int i = 0; i < 3; ++i) {
        const auto found = record.numbers.find(name + "." + "xyz"[i]);
        if (found == record.numbers.end()) return std::nullopt;
        (i == 0 ? v.x : i == 1 ? v.y : v.z) = found->second;
    }
    return v;
}

/// A mirror plane is given in the frame of the mirroring object's parent.
Placements mirrors(const RawRecord& copy) {
    const auto base = vector_of(copy, "Base"), normal = vector_of(copy, "Normal");
    if (!base || !normal || length(*normal) < 1e-12) return {};
    const gp_Trsf own = to_trsf(copy.placement), whole = to_trsf(copy.global_placement),
                  parent = whole * own.Inverted();
    Placements found;
    for (const gp_Trsf& frame : {parent, whole}) {
        gp_Trsf mirror;
        mirror.SetMirror(gp_Ax2(to_pnt(*base), gp_Dir(to_vec(*normal))));
        found.push_back(frame * mirror * frame.Inverted());
    }
    return found;
}

/// A link stands at its own placement, or at that and its source's.
Placements ways_to(const RawRecord& copy, const RawRecord& source) {
    Placements found = mirrors(copy);
    if (!found.empty()) return found;
    const gp_Trsf to = to_trsf(copy.global_placement), from = to_trsf(source.global_placement);
    return {to * from.Inverted(), to * to_trsf(source.placement) * from.Inverted()};
}

/// The feature's own volumes, as a copy of them is to know them.
Volumes named_volumes(const Feature& feature) {
    Volumes volumes = feature.volumes;
    for (FeatureVolume& volume : volumes)
        volume.copied_from.insert(volume.copied_from.begin(), {feature.name, volume.instance});
    return volumes;
}

}  // namespace

std::optional<Volumes> volumes_in_order(const FeatureTree& tree, FeatureId last) {
    const Feature& feature = tree[last];
    if (feature.combination == Combination::volumes) return named_volumes(feature);
    Volumes volumes;
    for (std::size_t k = 0; k < feature.operands.size(); ++k) {
        auto operand = volumes_in_order(tree, feature.operands[k]);
        if (!operand) return std::nullopt;
        if (k == 0)
            volumes = std::move(*operand);
        else if (!append_operand(volumes, *operand, feature.combination))
            return std::nullopt;
    }
    if (feature.combination == Combination::chain) {
        const Volumes own = named_volumes(feature);
        volumes.insert(volumes.end(), own.begin(), own.end());
    }
    return volumes;
}

std::optional<Volumes> copied_volumes(const RawRecord& copy, const RawRecord& source, const Volumes& volumes,
                                      const DocumentView& document) {
    for (const gp_Trsf& way : ways_to(copy, source)) {
        if (!same_solids(placed(document.geometry_of(source), way), document.geometry_of(copy))) continue;
        Volumes copies = volumes;
        for (std::size_t i = 0; i < copies.size(); ++i) {
            copies[i].shape = placed(copies[i].shape, way);
            copies[i].instance = static_cast<std::int64_t>(i);
            copies[i].motion = compose(to_motion(way), copies[i].motion);
        }
        return copies;
    }
    return std::nullopt;
}

}  // namespace featuremesh
