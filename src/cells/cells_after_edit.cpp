// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/cells_after_edit.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <memory>

#include "cells/fuse.h"
#include "cells/replay.h"
#include "features/face_probe.h"
#include "features/occt_geometry.h"
#include "features/same_faces.h"
#include "features/shape_print.h"
#include "features/solid_probe.h"

namespace featuremesh {

namespace {

constexpr double seconds_for_a_fuse = 5;
constexpr double share_that_pays = 0.7;  // of the solids, in both fuses together
constexpr double on_face = 1e-5;         // mm, as for the cells of a whole part
constexpr double same_normal = 0.999;    // cosine

/// One solid of one volume of a feature.
struct Piece {
    Owner owner;
    Effect effect, step;
    TopoDS_Shape solid;
    std::uint64_t print;
    Box box;
    bool is_changed = true;
};

using Pieces = std::vector<Piece>;

Pieces pieces_of(const FeatureTree& tree) {
    Pieces pieces;
    for (std::size_t f = 0; f < tree.features.size(); ++f)
        for (std::size_t v = 0; v < tree.features[f].volumes.size(); ++v) {
            const FeatureVolume& volume = tree.features[f].volumes[v];
            for (TopExp_Explorer it(volume.shape, TopAbs_SOLID); it.More(); it.Next())
                pieces.push_back({{FeatureId(f), int(v)},
                                  volume.effect,
                                  volume.step,
                                  it.Current(),
                                  print_of(it.Current()),
                                  box_of(it.Current())});
        }
    return pieces;
}

bool is_same(const Piece& a, const Piece& b) {
    if (a.effect != b.effect || a.step != b.step) return false;
    if (a.print == b.print) return true;
    const double close = 1e-6 * a.box.diagonal();
    if (distance(a.box.low, b.box.low) > close || distance(a.box.high, b.box.high) > close) return false;
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
            if (!o) continue;
            if (o->index() < next) return false;  // the order changed
            next = o->index() + 1;
            if (!is_combined_alike(old_.features[o->index()], new_.features[n]) || !pair(*o, FeatureId(n)))
                return false;
        }
        return true;
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

    /// Names of the operands that the other tree has too.
    static std::vector<std::string> operands(const FeatureTree& tree, const Feature& f, const FeatureTree& other) {
        std::vector<std::string> names;
        for (const FeatureId id : f.operands)
            if (other.find(tree[id].name)) names.push_back(tree[id].name);
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
            const auto partner = std::find_if(was.begin(), was.end(),
                                              [&](const Piece* p) { return p->is_changed && is_same(*p, *piece); });
            if (partner == was.end()) continue;
            if (partner - was.begin() < last) return false;
            last = partner - was.begin();
            (*partner)->is_changed = piece->is_changed = false;
        }
        return true;
    }

    const FeatureTree& old_;
    const FeatureTree& new_;

  public:
    Pieces old_pieces, new_pieces;
};

/// What the pieces of one state are within the box.
struct LocalCells {
    std::vector<Cell> cells;
    std::vector<CellFace> faces;  ///< their cells by index in `cells`; none for outside the box or all pieces
    double material = 0;          ///< mm^3
    std::vector<bool> is_material;
};

class LocalFuse {
  public:
    LocalFuse(const FeatureTree& tree, const Pieces& pieces, const Box& box, RunContext& context)
        : tree_(tree), marker_{FeatureId(tree.features.size()), 0}, context_(context) {
        for (const Piece& piece : pieces)
            if (piece.box.overlaps(box)) arguments_.push_back({piece.owner, piece.solid});
        arguments_.push_back({marker_, BRepPrimAPI_MakeBox(to_pnt(box.low), to_pnt(box.high)).Solid()});
    }

    std::size_t argument_count() const { return arguments_.size(); }

    std::optional<LocalCells> run() const {
        FusedComplex complex = fuse(arguments_, {0, seconds_for_a_fuse}, context_);
        if (!complex.trouble.empty() || !complex.offenders.empty()) return std::nullopt;
        LocalCells local;
        std::vector<CellId> new_id(complex.cells.size());
        for (std::size_t c = 0; c < complex.cells.size(); ++c) {
            Cell& cell = complex.cells[c];
            if (std::erase(cell.owners, marker_) == 0) continue;
            new_id[c] = CellId(local.cells.size());
            local.cells.push_back(std::move(cell));
        }
        for (CellFace& face : complex.faces) {
            if (std::erase(face.owners, marker_) > 0 && face.owners.empty()) continue;  // the side of the box
            for (CellId& id : face.cells)
                if (id.is_valid()) id = new_id[id.index()];
            if (face.cells[0].is_valid() || face.cells[1].is_valid()) local.faces.push_back(std::move(face));
        }
        local.is_material = replay(tree_, local.cells);
        for (std::size_t c = 0; c < local.cells.size(); ++c)
            if (local.is_material[c]) local.material += local.cells[c].volume;
        return local;
    }

  private:
    const FeatureTree& tree_;
    const Owner marker_;
    RunContext& context_;
    std::vector<FuseArgument> arguments_;
};

double volume_of(const Brep& shape) {
    double volume = 0;
    for (std::size_t s = 0; s < shape.solid_count(); ++s) volume += shape.volume_of(SolidId(s));
    return volume;
}

/// The final shape says what is material; the tree only foretells it.
bool tells_the_truth(const LocalCells& local, const Brep& final_shape, double final_volume) {
    std::vector<std::unique_ptr<SolidProbe>> probes;
    for (std::size_t s = 0; s < final_shape.solid_count(); ++s)
        probes.push_back(std::make_unique<SolidProbe>(final_shape.solid(SolidId(s))));
    for (std::size_t c = 0; c < local.cells.size(); ++c) {
        if (local.cells[c].volume <= Tolerances::volume_books * final_volume) continue;
        const auto inner = point_inside(local.cells[c].solid);
        if (!inner) return false;
        const auto holders = std::count_if(probes.begin(), probes.end(),
                                           [&](const auto& probe) { return probe->side_of(*inner) == Side::inside; });
        if (holders > 1 || (holders == 1) != local.is_material[c]) return false;
    }
    return true;
}

/// Owners of the final faces that cell faces between material and void lie on.
std::vector<std::vector<Owner>> owners_in_box(const LocalCells& local, const Brep& final_shape, const Box& box) {
    std::vector<std::vector<Owner>> owners(final_shape.face_count());
    std::vector<std::unique_ptr<FaceProbe>> probes;
    for (std::size_t f = 0; f < final_shape.face_count(); ++f) {
        auto probe = std::make_unique<FaceProbe>(final_shape.face(FaceId(f)));
        probes.push_back(probe->box().overlaps(box) ? std::move(probe) : nullptr);
    }
    const auto is_material = [&](CellId id) { return id.is_valid() && local.is_material[id.index()]; };
    for (const CellFace& face : local.faces) {
        if (is_material(face.cells[0]) == is_material(face.cells[1])) continue;
        const FaceProbe probe(face.face);
        if (!probe.inner_point()) continue;
        const Vec3 p = *probe.inner_point();
        if (!box.contains(p)) continue;
        // The point is on the final boundary: where only one face comes near it, that face's trim need not be asked.
        std::vector<std::size_t> near;
        for (std::size_t f = 0; f < probes.size(); ++f)
            if (probes[f] && probes[f]->box().grown(on_face).contains(p) &&
                probes[f]->distance_to_surface(p) < on_face &&
                std::abs(dot(probes[f]->normal_at(p), probe.normal_at(p))) > same_normal)
                near.push_back(f);
        for (const std::size_t f : near)
            if (near.size() == 1 || probes[f]->contains(p, on_face))
                owners[f].insert(owners[f].end(), face.owners.begin(), face.owners.end());
    }
    for (auto& list : owners) {
        std::sort(list.begin(), list.end());
        list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return owners;
}

/// Around everything that changed, with sides that lie in no plane of the part.
Box box_around_changes(const Pieces& old_pieces, const Pieces& new_pieces) {
    Box box;
    for (const Pieces* pieces : {&old_pieces, &new_pieces})
        for (const Piece& piece : *pieces)
            if (piece.is_changed) box.add(piece.box);
    return box.is_empty() ? box : box.grown(0.0371 * box.diagonal());
}

std::vector<double> feature_volumes(const CellsBefore& before, const FeatureTree& tree, const LocalCells& was,
                                    const LocalCells& is) {
    const std::vector<double> lost = volumes_of_features(was.cells, before.tree.features.size());
    std::vector<double> volumes = volumes_of_features(is.cells, tree.features.size());
    for (std::size_t f = 0; f < volumes.size(); ++f)
        if (const auto old = before.tree.find(tree.features[f].name))
            volumes[f] += before.cells.feature_volumes[old->index()] - lost[old->index()];
    return volumes;
}

}  // namespace

std::optional<CellModel> cells_after_edit(const CellsBefore& before, const FeatureTree& tree, const Brep& final_shape,
                                          RunContext& context) {
    const RunContext::Step step(context, "cells");
    const CellReport& old_report = before.cells.report;
    if (!old_report.fallbacks.empty() || !old_report.findings.empty() || !old_report.untrusted.empty())
        return std::nullopt;
    Pairing pairing(before.tree, tree);
    if (!pairing.run()) return std::nullopt;
    const Box box = box_around_changes(pairing.old_pieces, pairing.new_pieces);
    CellModel model;
    model.is_summary = true;
    model.edited = box;
    model.owners_of_final_face.resize(final_shape.face_count());
    const double volume = volume_of(final_shape);
    LocalCells was, is;
    if (!box.is_empty()) {
        const LocalFuse old_fuse(before.tree, pairing.old_pieces, box, context),
            new_fuse(tree, pairing.new_pieces, box, context);
        if (double(old_fuse.argument_count() + new_fuse.argument_count()) >
            2 + share_that_pays * double(pairing.new_pieces.size()))
            return std::nullopt;
        auto old_cells = old_fuse.run(), new_cells = new_fuse.run();
        if (!old_cells || !new_cells || !tells_the_truth(*new_cells, final_shape, volume)) return std::nullopt;
        was = std::move(*old_cells), is = std::move(*new_cells);
        model.owners_of_final_face = owners_in_box(is, final_shape, box);
    }
    model.report.material_volume = old_report.material_volume - was.material + is.material;
    model.report.final_volume = volume;
    if (std::abs(model.report.material_volume - volume) > Tolerances::volume_books * volume) return std::nullopt;
    model.feature_volumes = feature_volumes(before, tree, was, is);
    return model;
}

}  // namespace featuremesh
