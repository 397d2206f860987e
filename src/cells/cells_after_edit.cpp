// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/cells_after_edit.h"

#include <TopExp_Explorer.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <set>

#include "cells/fuse.h"
#include "cells/replay.h"
#include "features/face_probe.h"
#include "features/flux.h"
#include "features/occt_geometry.h"
#include "features/same_faces.h"
#include "features/shape_print.h"
#include "features/solid_probe.h"

namespace featuremesh {

namespace {

constexpr double seconds_for_a_fuse = 0.5;  // of the processor; owners are not worth more while a mesh is waited for
constexpr double share_that_pays = 0.7;     // of the solids, in both fuses together

/// One solid of one volume of a feature.
struct Piece {
    Owner owner;
    Effect effect, step;
    TopoDS_Shape solid;
    std::uint64_t print;
    bool is_changed = true;
    std::optional<Owner> old_owner = {};  ///< of its partner, for a new piece
    const Piece* twin = nullptr;          ///< of the same print
    std::optional<Box> known_box = {};

    const Box& box() {
        if (!known_box) known_box = twin && twin->known_box ? *twin->known_box : box_of(solid);
        return *known_box;
    }
};

using Pieces = std::vector<Piece>;

Pieces pieces_of(const FeatureTree& tree) {
    Pieces pieces;
    for (std::size_t f = 0; f < tree.features.size(); ++f)
        for (std::size_t v = 0; v < tree.features[f].volumes.size(); ++v) {
            const FeatureVolume& volume = tree.features[f].volumes[v];
            for (TopExp_Explorer it(volume.shape, TopAbs_SOLID); it.More(); it.Next())
                pieces.push_back(
                    {{FeatureId(f), int(v)}, volume.effect, volume.step, it.Current(), print_of(it.Current())});
        }
    return pieces;
}

bool is_same(Piece& a, Piece& b) {
    if (a.effect != b.effect || a.step != b.step) return false;
    if (a.print == b.print) return true;
    const double close = 1e-6 * a.box().diagonal();
    if (distance(a.box().low, b.box().low) > close || distance(a.box().high, b.box().high) > close) return false;
    return unshared_faces(a.solid, b.solid).empty() && unshared_faces(b.solid, a.solid).empty();
}

/// Finds the changes between two trees whose features, as far as both have them, are combined alike.
class Pairing {
  public:
    Pairing(const FeatureTree& old_tree, const FeatureTree& new_tree)
        : old_(old_tree), new_(new_tree), old_pieces(pieces_of(old_tree)), new_pieces(pieces_of(new_tree)) {}

    bool run() {
        std::vector<std::size_t> last_of_old;
        std::size_t next = 0;
        for (std::size_t n = 0; n < new_.features.size(); ++n) {
            const auto o = old_.find(new_.features[n].name);
            if (!o && !is_local(new_.features[n])) return false;
            if (!o) continue;
            if (o->index() < next) return false;  // the order changed
            next = o->index() + 1;
            if (!is_combined_alike(old_.features[o->index()], new_.features[n]) || !pair(*o, FeatureId(n)))
                return false;
        }
        return std::all_of(old_.features.begin(), old_.features.end(),
                           [&](const Feature& f) { return new_.find(f.name) || is_local(f); });
    }

  private:
    static bool is_local(const Feature& f) {
        return f.error.empty() && f.combination != Combination::common &&
               std::none_of(f.volumes.begin(), f.volumes.end(), [](const FeatureVolume& v) {
                   return v.effect == Effect::keeps_only || v.step == Effect::keeps_only;
               });
    }

    bool is_combined_alike(const Feature& was, const Feature& is) const {
        return was.combination == is.combination && is_local(was) && is_local(is) &&
               operands(old_, was, new_) == operands(new_, is, old_);
    }

    /// Names of the operands; in place of one that the other tree does not have those that it works on itself, for
    /// without its own volumes it passes them on.
    static std::vector<std::string> operands(const FeatureTree& tree, const Feature& f, const FeatureTree& other) {
        std::vector<std::string> names;
        for (const FeatureId id : f.operands) {
            const Feature& operand = tree[id];
            const std::vector<std::string> passed =
                other.find(operand.name) ? std::vector{operand.name} : operands(tree, operand, other);
            names.insert(names.end(), passed.begin(), passed.end());
        }
        return names;
    }

    /// False when paired pieces do not follow one another in the same order.
    bool pair(FeatureId old_id, FeatureId new_id) {
        const auto of = [](Pieces& pieces, FeatureId id) {
            std::vector<Piece*> own;
            const auto first = std::lower_bound(pieces.begin(), pieces.end(), id,
                                                [](const Piece& p, FeatureId f) { return p.owner.feature < f; });
            for (auto it = first; it != pieces.end() && it->owner.feature == id; ++it) own.push_back(&*it);
            return own;
        };
        const std::vector<Piece*> was = of(old_pieces, old_id), is = of(new_pieces, new_id);
        std::ptrdiff_t last = -1;
        for (Piece* piece : is) {
            const auto partner =
                std::find_if(was.begin(), was.end(), [&](Piece* p) { return p->is_changed && is_same(*p, *piece); });
            if (partner == was.end()) continue;
            if (partner - was.begin() < last) return false;
            last = partner - was.begin();
            (*partner)->is_changed = piece->is_changed = false;
            piece->old_owner = (*partner)->owner;
            if ((*partner)->print == piece->print) piece->twin = *partner;
        }
        return true;
    }

    const FeatureTree& old_;
    const FeatureTree& new_;

  public:
    Pieces old_pieces, new_pieces;
};

/// Cells of one state, of which those in a changed piece are told apart.
struct LocalCells {
    std::vector<Cell> with, without;  ///< the same cells with all their owners, and with those pieces only that stayed
    std::vector<CellFace> faces_with, faces_without;
    std::vector<bool> is_edited;  ///< by cell: in a changed piece; only around those are the owners complete
    std::vector<bool> material_with, material_without;

    /// Material that the changed pieces make, mm^3.
    double gain() const {
        double sum = 0;
        for (std::size_t c = 0; c < with.size(); ++c)
            if (is_edited[c]) sum += (material_with[c] - material_without[c]) * with[c].volume;
        return sum;
    }
    /// By feature: what the changed pieces add to it, mm^3.
    std::vector<double> gains(std::size_t feature_count) const {
        std::vector<double> sums = volumes_of_features(edited(with), feature_count);
        const std::vector<double> others = volumes_of_features(edited(without), feature_count);
        for (std::size_t f = 0; f < feature_count; ++f) sums[f] -= others[f];
        return sums;
    }

  private:
    std::vector<Cell> edited(const std::vector<Cell>& cells) const {
        std::vector<Cell> list;
        for (std::size_t c = 0; c < cells.size(); ++c)
            if (is_edited[c]) list.push_back(cells[c]);
        return list;
    }
};

/// The changed pieces of one state and all others that may reach into them.
class LocalFuse {
  public:
    LocalFuse(const FeatureTree& tree, Pieces& pieces, RunContext& context) : tree_(tree), context_(context) {
        std::vector<Piece*> changed;
        for (Piece& piece : pieces)
            if (piece.is_changed) changed.push_back(&piece);
        for (Piece& piece : pieces)
            if (piece.is_changed) {
                arguments_.push_back({{FeatureId(tree.features.size() + owners_.size()), 0}, piece.solid});
                owners_.push_back(piece.owner);
            } else if (std::any_of(changed.begin(), changed.end(),
                                   [&](Piece* c) { return c->box().overlaps(piece.box()); })) {
                arguments_.push_back({piece.owner, piece.solid});
            }
    }

    std::size_t argument_count() const { return owners_.empty() ? 0 : arguments_.size(); }

    std::optional<LocalCells> run() const {
        LocalCells local;
        if (owners_.empty()) return local;
        FusedComplex complex = fuse(arguments_, {0, seconds_for_a_fuse}, context_);
        if (!complex.trouble.empty() || !complex.offenders.empty()) return std::nullopt;
        local.with = local.without = std::move(complex.cells);
        local.faces_with = local.faces_without = std::move(complex.faces);
        for (std::size_t c = 0; c < local.with.size(); ++c) {
            local.is_edited.push_back(erase_markers(local.without[c].owners));
            resolve_markers(local.with[c].owners);
        }
        for (std::size_t f = 0; f < local.faces_with.size(); ++f) {
            erase_markers(local.faces_without[f].owners);
            resolve_markers(local.faces_with[f].owners);
        }
        local.material_with = replay(tree_, local.with);
        local.material_without = replay(tree_, local.without);
        return local;
    }

  private:
    bool is_marker(const Owner& owner) const { return owner.feature.index() >= tree_.features.size(); }
    bool erase_markers(std::vector<Owner>& owners) const {
        return std::erase_if(owners, [&](const Owner& owner) { return is_marker(owner); }) > 0;
    }
    void resolve_markers(std::vector<Owner>& owners) const {
        for (Owner& owner : owners)
            if (is_marker(owner)) owner = owners_[owner.feature.index() - tree_.features.size()];
        std::sort(owners.begin(), owners.end());
        owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    }

    const FeatureTree& tree_;
    RunContext& context_;
    std::vector<FuseArgument> arguments_;  // a changed piece has a marker for its owner
    std::vector<Owner> owners_;            // by marker
};

using Probes = std::vector<std::unique_ptr<SolidProbe>>;

Probes probes_of_changed(const Pieces& pieces) {
    Probes probes;
    for (const Piece& piece : pieces)
        if (piece.is_changed) probes.push_back(std::make_unique<SolidProbe>(piece.solid));
    return probes;
}

bool is_outside(const Probes& probes, const Vec3& p) {
    return std::all_of(probes.begin(), probes.end(),
                       [&](const auto& probe) { return probe->side_of(p) == Side::outside; });
}

/// The new state where something changed: within the new pieces, and where old ones were that no new one covers.
class NewState {
  public:
    NewState(const LocalCells& was, const LocalCells& is, const Pieces& new_pieces, const Brep& final_shape)
        : was_(was), is_(is), new_probes_(probes_of_changed(new_pieces)), final_shape_(final_shape) {}

    /// The final shape says what is material; the tree only foretells it.
    bool tells_the_truth(double final_volume) const {
        Probes solids;
        for (std::size_t s = 0; s < final_shape_.solid_count(); ++s)
            solids.push_back(std::make_unique<SolidProbe>(final_shape_, SolidId(s)));
        const auto is_true = [&](const Cell& cell, bool is_material, bool may_be_covered) {
            if (cell.volume <= Tolerances::volume_books * final_volume) return true;
            const auto inner = point_inside(cell.solid);
            if (!inner) return false;
            if (may_be_covered && !is_outside(new_probes_, *inner)) return true;
            const auto holders = std::count_if(solids.begin(), solids.end(), [&](const auto& probe) {
                return probe->side_of(*inner) == Side::inside;
            });
            return holders <= 1 && (holders == 1) == is_material;
        };
        for (std::size_t c = 0; c < is_.with.size(); ++c)
            if (is_.is_edited[c] && !is_true(is_.with[c], is_.material_with[c], false)) return false;
        for (std::size_t c = 0; c < was_.without.size(); ++c)
            if (was_.is_edited[c] && !is_true(was_.without[c], was_.material_without[c], true)) return false;
        return true;
    }

    /// Owners of the final faces that cell faces between material and void lie on.
    std::vector<std::vector<Owner>> owners_of_final_faces() {
        owners_.resize(final_shape_.face_count());
        for (std::size_t f = 0; f < final_shape_.face_count(); ++f) {
            const Box& box = final_shape_.box_of(FaceId(f));
            boxes_.push_back(box.grown(boolean_tolerance));
        }
        final_faces_.resize(boxes_.size());
        add_owners(is_.faces_with, is_.is_edited, is_.material_with, false);
        add_owners(was_.faces_without, was_.is_edited, was_.material_without, true);
        for (auto& list : owners_) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
        return std::move(owners_);
    }

  private:
    void add_owners(const std::vector<CellFace>& faces, const std::vector<bool>& is_edited,
                    const std::vector<bool>& material, bool may_be_covered) {
        const auto has = [](const std::vector<bool>& marks, CellId id) { return id.is_valid() && marks[id.index()]; };
        for (const CellFace& face : faces) {
            const auto& [one, other] = face.cells;
            if (has(material, one) == has(material, other) || !(has(is_edited, one) || has(is_edited, other))) continue;
            const FaceProbe probe(face.face);
            if (!probe.inner_point()) continue;
            const Vec3 p = *probe.inner_point();
            if (!may_be_covered || is_outside(new_probes_, p)) give(face.owners, p, probe.normal_at(p));
        }
    }

    /// The point is on the final boundary: where only one face comes near it, that face's trim need not be asked.
    void give(const std::vector<Owner>& owners, const Vec3& p, const Vec3& normal) {
        std::vector<std::size_t> near;
        for (std::size_t f = 0; f < boxes_.size(); ++f) {
            if (!boxes_[f].contains(p)) continue;
            if (!final_faces_[f]) final_faces_[f] = std::make_unique<FaceProbe>(final_shape_.face(FaceId(f)));
            if (final_faces_[f]->distance_to_surface(p) < boolean_tolerance &&
                std::abs(dot(final_faces_[f]->normal_at(p), normal)) > same_normal)
                near.push_back(f);
        }
        for (const std::size_t f : near)
            if (near.size() == 1 || final_faces_[f]->contains(p, boolean_tolerance))
                owners_[f].insert(owners_[f].end(), owners.begin(), owners.end());
    }

    const LocalCells& was_;
    const LocalCells& is_;
    Probes new_probes_;
    const Brep& final_shape_;
    std::vector<Box> boxes_;
    std::vector<std::unique_ptr<FaceProbe>> final_faces_;  // built when first asked for
    std::vector<std::vector<Owner>> owners_;
};

/// Owners of the new tree none of whose pieces reaches out of the changed ones.
std::vector<Owner> owners_within_edit(const Pairing& pairing, const LocalCells& was, const LocalCells& is) {
    std::set<Owner> within, outside;
    const auto sort_out = [](const LocalCells& local, std::set<Owner>& in, std::set<Owner>& out) {
        for (std::size_t c = 0; c < local.with.size(); ++c)
            (local.is_edited[c] ? in : out).insert(local.without[c].owners.begin(), local.without[c].owners.end());
    };
    sort_out(is, within, outside);
    std::set<Owner> fused = within;
    fused.insert(outside.begin(), outside.end());
    for (const Piece& piece : pairing.new_pieces)
        if (piece.is_changed)
            within.insert(piece.owner);
        else if (fused.count(piece.owner) == 0)
            outside.insert(piece.owner);
    std::set<Owner> old_within, old_outside;
    sort_out(was, old_within, old_outside);
    for (const Piece& piece : pairing.new_pieces)
        if (piece.old_owner && old_within.count(*piece.old_owner) && !old_outside.count(*piece.old_owner)) {
            within.insert(piece.owner);
            outside.erase(piece.owner);
        }
    std::vector<Owner> owners;
    std::set_difference(within.begin(), within.end(), outside.begin(), outside.end(), std::back_inserter(owners));
    return owners;
}

std::vector<double> feature_volumes(const CellsBefore& before, const FeatureTree& tree, const LocalCells& was,
                                    const LocalCells& is) {
    const std::vector<double> lost = was.gains(before.tree.features.size());
    std::vector<double> volumes = is.gains(tree.features.size());
    for (std::size_t f = 0; f < volumes.size(); ++f)
        if (const auto old = before.tree.find(tree.features[f].name))
            volumes[f] += before.cells.feature_volumes[old->index()] - lost[old->index()];
    return volumes;
}

bool has_same_volumes(const Feature& was, const Feature& is) {
    return std::equal(
        was.volumes.begin(), was.volumes.end(), is.volumes.begin(), is.volumes.end(),
        [](const FeatureVolume& a, const FeatureVolume& b) { return print_of(a.shape) == print_of(b.shape); });
}

bool is_untrusted(const CellModel& cells, FeatureId id) {
    const auto& untrusted = cells.report.untrusted;
    return std::find(untrusted.begin(), untrusted.end(), id) != untrusted.end();
}

double sum_of_volumes(const Feature& feature, const Vec3& apex) {
    double sum = 0;
    for (const FeatureVolume& volume : feature.volumes) sum += std::abs(flux(volume.shape, apex));
    return sum;
}

}  // namespace

CellModel cells_without_fuse(const FeatureTree& tree, const Brep& final_shape, const CellsBefore* before) {
    CellModel model;
    model.is_summary = true;
    model.report.material_volume = model.report.final_volume = final_shape.volume();
    for (std::size_t f = 0; f < tree.features.size(); ++f) {
        const Feature& feature = tree.features[f];
        const auto old = before ? before->tree.find(feature.name) : std::nullopt;
        model.feature_volumes.push_back(old && has_same_volumes(before->tree[*old], feature)
                                            ? before->cells.feature_volumes[old->index()]
                                            : sum_of_volumes(feature, final_shape.box().center()));
        if (!feature.error.empty() || (old && is_untrusted(before->cells, *old)))
            model.report.untrusted.push_back(FeatureId(f));
    }
    return model;
}

std::optional<CellModel> cells_after_edit(const CellsBefore& before, const FeatureTree& tree, const Brep& final_shape,
                                          RunContext& context) {
    const RunContext::Step step(context, "cells");
    const CellReport& old_report = before.cells.report;
    if (!old_report.fallbacks.empty() || !old_report.findings.empty() || !old_report.untrusted.empty())
        return cells_without_fuse(tree, final_shape, &before);
    Pairing pairing(before.tree, tree);
    if (!pairing.run()) return cells_without_fuse(tree, final_shape, &before);
    CellModel model;
    model.is_summary = true;
    const LocalFuse old_fuse(before.tree, pairing.old_pieces, context), new_fuse(tree, pairing.new_pieces, context);
    if (double(old_fuse.argument_count() + new_fuse.argument_count()) >
        2 + share_that_pays * double(pairing.new_pieces.size()))
        return cells_without_fuse(tree, final_shape, &before);
    const auto was = old_fuse.run(), is = new_fuse.run();
    if (!was || !is) return cells_without_fuse(tree, final_shape, &before);
    const double volume = final_shape.volume();
    NewState now(*was, *is, pairing.new_pieces, final_shape);
    if (!now.tells_the_truth(volume)) return std::nullopt;
    model.owners_of_final_face = now.owners_of_final_faces();
    model.owners_within_edit = owners_within_edit(pairing, *was, *is);
    model.report.material_volume = old_report.material_volume - was->gain() + is->gain();
    model.report.final_volume = volume;
    if (std::abs(model.report.material_volume - volume) > Tolerances::volume_books * volume) return std::nullopt;
    model.feature_volumes = feature_volumes(before, tree, *was, *is);
    return model;
}

}  // namespace featuremesh
