// SPDX-License-Identifier: GPL-3.0-or-later
#include "features/copied_volumes.h"

#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <gp_Ax2.hxx>
#include <span>

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

std::vector<TopoDS_Shape> solids_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> solids;
    for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) solids.push_back(it.Current());
    return solids;
}

bool has_solids(std::span<const TopoDS_Shape> solids, const TopoDS_Shape& wanted) {
    TopoDS_Compound whole;
    BRep_Builder().MakeCompound(whole);
    for (const TopoDS_Shape& solid : solids) BRep_Builder().Add(whole, solid);
    return same_solids(wanted, whole);
}

/// From the source to each element of an array, in their order; none where that is no array of it.
Placements ways_to_elements(const TopoDS_Shape& array, const TopoDS_Shape& source) {
    const std::vector<TopoDS_Shape> to = solids_of(array), from = solids_of(source);
    Placements ways;
    if (from.empty() || to.size() % from.size() != 0) return ways;
    for (std::size_t k = 0; k < to.size(); k += from.size()) {
        const gp_Trsf way = (to[k].Location() * from[0].Location().Inverted()).Transformation();
        const bool is_known = k > 0 && from.size() == 1 && to[k].IsPartner(to[0]);
        if (!is_known && !has_solids(std::span(to).subspan(k, from.size()), placed(source, way))) return {};
        ways.push_back(way);
    }
    return ways;
}

FeatureVolume copied(FeatureVolume volume, const gp_Trsf& way) {
    volume.shape = placed(volume.shape, way);
    volume.motion = compose(to_motion(way), volume.motion);
    return volume;
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
    const TopoDS_Shape &from = document.geometry_of(source), &to = document.geometry_of(copy);
    Volumes copies;
    for (const gp_Trsf& way : ways_to(copy, source)) {
        if (!same_solids(placed(from, way), to)) continue;
        for (const FeatureVolume& volume : volumes) {
            copies.push_back(copied(volume, way));
            copies.back().instance = static_cast<std::int64_t>(copies.size()) - 1;
        }
        return copies;
    }
    // What limits one element would limit those before it, too.
    if (std::any_of(volumes.begin(), volumes.end(), [](const auto& v) { return v.step == Effect::keeps_only; }))
        return std::nullopt;
    std::int64_t element = 0;
    for (const gp_Trsf& way : ways_to_elements(to, from)) {
        for (const FeatureVolume& volume : volumes) {
            copies.push_back(copied(volume, way));
            copies.back().instance = element;
            copies.back().copied_from.insert(copies.back().copied_from.begin(), {copy.name, element});
        }
        ++element;
    }
    return copies.empty() ? std::nullopt : std::optional(copies);
}

}  // namespace featuremesh
