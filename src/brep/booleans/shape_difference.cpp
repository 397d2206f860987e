// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/booleans/shape_difference.h"

#include <BOPAlgo_BOP.hxx>
#include <BOPAlgo_MakerVolume.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <Message_ProgressScope.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "brep/booleans/counted_filler.h"
#include "brep/booleans/glued_filler.h"
#include "brep/booleans/work_limit.h"
#include "brep/occt_geometry.h"
#include "brep/same_faces.h"
#include "brep/shape_print.h"
#include "brep/solid_probe.h"
#include "brep/volumes/flux.h"
#include "brep/volumes/patch_volumes.h"
#include "core/geometry.h"
#include "core/on_threads.h"

namespace featuremesh {

namespace {

constexpr double volume_share = 1e-6;  // as the books of the cells

std::vector<TopoDS_Shape> solids_of(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Shape> solids;
    if (!shape.IsNull())
        for (TopExp_Explorer it(shape, TopAbs_SOLID); it.More(); it.Next()) solids.push_back(it.Current());
    return solids;
}

/// The faces that only one of two shapes has.
struct ChangedFaces {
    std::vector<TopoDS_Shape> vanished, appeared;

    ChangedFaces(const TopoDS_Shape& before, const TopoDS_Shape& after)
        : vanished(unshared_faces(before, after)), appeared(unshared_faces(after, before)) {}
    std::uint64_t print() const { return 3 * print_of(vanished) + print_of(appeared); }
};

struct Change : ChangedFaces {
    const TopoDS_Shape& before;
    const TopoDS_Shape& after;
    std::vector<double> flux_of_vanished, flux_of_appeared;
    Vec3 apex;
    double volume = 0, scale = 0;

    Change(ChangedFaces changed, const TopoDS_Shape& b, const TopoDS_Shape& a)
        : ChangedFaces(std::move(changed)), before(b), after(a) {
        Box box;
        std::vector<double> widths;
        for (const auto* faces : {&vanished, &appeared})
            for (const TopoDS_Shape& face : *faces) {
                const Box its = box_of(face);
                widths.push_back(its.diagonal());
                box.add(its);
            }
        if (box.is_empty()) return;
        apex = box.center();
        auto width = widths.begin();
        for (const auto& [faces, fluxes] :
             {std::pair{&vanished, &flux_of_vanished}, std::pair{&appeared, &flux_of_appeared}})
            for (const TopoDS_Shape& face : *faces) fluxes->push_back(flux(TopoDS::Face(face), apex, *width++));
        const double gained = std::accumulate(flux_of_appeared.begin(), flux_of_appeared.end(), 0.0);
        const double lost = std::accumulate(flux_of_vanished.begin(), flux_of_vanished.end(), 0.0);
        volume = gained - lost;
        scale = std::max({std::abs(gained), std::abs(lost), 1e-3 * box.size().x * box.size().y * box.size().z});
    }

    /// Intersections with a shape that is not valid may take the kernel hours, whatever their price.
    bool is_of_sound_shapes() const {
        return BRepCheck_Analyzer(before).IsValid() && BRepCheck_Analyzer(after).IsValid();
    }

    bool is_explained_by(const ShapeDifference& d) const {
        double sum = 0;
        for (const auto& [solids, sign] : {std::pair{&d.added, 1}, std::pair{&d.removed, -1}})
            for (const TopoDS_Shape& solid : *solids) {
                const double share = flux(solid, apex);
                if (share < -volume_share * scale) return false;  // a solid inside out is several that cross each other
                sum += sign * share;
            }
        return is_explained_by(sum);
    }

    bool is_explained_by(double sum) const {
        const double error = std::abs(sum - volume);
        // What the kernel approximates anew is a little off; the books are kept for the part as a whole.
        return error <= volume_share * scale ||
               error <= 0.1 * volume_share * std::abs(flux(after, box_of(after).center()));
    }
};

/// The volumes between the faces that vanished and those that appeared, without the kernel where faces meet along edges
/// that one of them has.
ShapeDifference along_edges(const Change& change) {
    ShapeDifference result;
    result.is_hopeless = true;
    auto volumes = patch_volumes(
        {change.vanished, change.appeared, change.flux_of_vanished, change.flux_of_appeared, change.apex});
    if (!volumes || !change.is_explained_by(volumes->change)) return result;
    result.added = std::move(volumes->added);
    result.removed = std::move(volumes->removed);
    result.closed = true;
    return result;
}

/// The volumes between the faces that vanished and those that appeared. `glued`: faces are not intersected with each
/// other, for mostly they meet along edges that one of them has anyway; that is several times faster where the faces
/// are splines, but misses a drafted face that crosses the one it was before.
ShapeDifference between_faces(const Change& change, bool glued, Work most, RunContext& context) {
    ShapeDifference result;
    TopTools_ListOfShape faces;
    const auto add = [&](const std::vector<TopoDS_Shape>& some, const std::vector<TopoDS_Shape>& others) {
        for (const TopoDS_Shape& face : glued ? without_common_holes(some, others) : some) faces.Append(face);
    };
    add(change.vanished, change.appeared);
    add(change.appeared, change.vanished);
    if (faces.IsEmpty()) return result.closed = true, result;
    const Handle(WorkLimit) limit = new WorkLimit(most, context);
    const std::unique_ptr<CountedFiller> filler(glued ? new GluedFiller : new CountedFiller);
    filler->pay_from(limit);
    filler->SetArguments(faces);
    filler->SetNonDestructive(true);
    filler->SetRunParallel(context.threads > 1);
    BOPAlgo_MakerVolume maker;
    maker.SetArguments(faces);
    maker.SetIntersect(true);
    maker.SetAvoidInternalShapes(true);
    maker.SetToFillHistory(false);
    maker.SetRunParallel(context.threads > 1);
    on_threads(context, [&] {
        Message_ProgressScope scope(limit->Start(), "volumes between faces", 10);
        filler->Perform(scope.Next(9));
        maker.PerformWithFiller(*filler, scope.Next());
    });
    result.is_hopeless = !limit->is_over();
    result.work = limit->spent();
    if (!result.is_hopeless || maker.HasErrors()) return result;
    const SolidProbe before(change.before);
    const SolidProbe after(change.after);
    for (const TopoDS_Shape& solid : solids_of(maker.Shape())) {
        context.progress(0.5);
        const auto inner = point_inside(solid);
        if (!inner) continue;  // a sliver, or its volume will be missed
        const bool was = before.containment_of(*inner) == Containment::inside,
                   is = after.containment_of(*inner) == Containment::inside;
        if (is && !was) result.added.push_back(solid);
        if (was && !is) result.removed.push_back(solid);
    }
    result.closed = change.is_explained_by(result);
    return result;
}

/// Adds the work to the result's, and says there whether it came to its end.
std::vector<TopoDS_Shape> cut(const TopoDS_Shape& from, const TopoDS_Shape& tool, Work most, RunContext& context,
                              ShapeDifference& result) {
    TopTools_ListOfShape all;
    all.Append(from);
    all.Append(tool);
    const Handle(WorkLimit) limit = new WorkLimit(most, context);
    CountedFiller filler;
    filler.pay_from(limit);
    filler.SetArguments(all);
    filler.SetNonDestructive(true);
    filler.SetRunParallel(context.threads > 1);
    BOPAlgo_BOP algorithm;
    algorithm.AddArgument(from);
    algorithm.AddTool(tool);
    algorithm.SetOperation(BOPAlgo_CUT);
    algorithm.SetNonDestructive(true);
    algorithm.SetRunParallel(context.threads > 1);
    on_threads(context, [&] {
        Message_ProgressScope scope(limit->Start(), "cut", 10);
        filler.Perform(scope.Next(9));
        if (!filler.HasErrors()) algorithm.PerformWithFiller(filler, scope.Next());
    });
    result.is_hopeless = !limit->is_over();
    result.work += limit->spent();
    result.closed = result.is_hopeless && !filler.HasErrors() && !algorithm.HasErrors();
    return result.closed ? solids_of(algorithm.Shape()) : std::vector<TopoDS_Shape>();
}

ShapeDifference by_booleans(const Change& change, Work most, RunContext& context) {
    ShapeDifference result;
    result.added = cut(change.after, change.before, most, context, result);
    if (result.closed) result.removed = cut(change.before, change.after, most, context, result);
    result.closed = result.closed && change.is_explained_by(result);
    return result;
}

ShapeDifference without_work(ShapeDifference known) {
    known.work = 0;
    return known;
}

}  // namespace

ShapeDifference difference_of(const TopoDS_Shape& before, const TopoDS_Shape& after, Work most, RunContext& context,
                              const ShapeDifference* known) {
    if (solids_of(before).empty()) return {solids_of(after), {}, true};
    if (solids_of(after).empty()) return {{}, solids_of(before), true};
    ShapeDifference result;
    ChangeOutline outline;
    std::uint64_t print = 0;
    Work left = most;
    const auto share_of_left = [&](double share) { return static_cast<Work>(share * static_cast<double>(left)); };
    try {
        // The volumes lie between the faces that only one of the shapes has, and nothing else counts.
        ChangedFaces faces(before, after);
        print = faces.print();
        if (known && print == known->print && (known->is_hopeless || known->closed)) return without_work(*known);
        const Change change(std::move(faces), before, after);
        outline = ChangeOutline(change.vanished, change.appeared);
        if (known && outline.matches(known->outline) &&
            (known->is_hopeless || (known->closed && change.is_explained_by(*known)))) {
            result = without_work(*known);
            result.print = print;
            return result;
        }
        bool is_hopeless = true;
        const auto attempt = [&](auto&& by) {
            if (result.closed) return;
            result = by();
            left -= result.work;
            is_hopeless = is_hopeless && result.is_hopeless;
        };
        if (most > 0) attempt([&] { return along_edges(change); });
        context.progress(0.5);
        if (!result.closed && change.is_of_sound_shapes()) {
            attempt([&] { return between_faces(change, true, share_of_left(0.7), context); });
            attempt([&] { return between_faces(change, false, share_of_left(0.7), context); });
            attempt([&] { return by_booleans(change, share_of_left(0.5), context); });
        }
        result.is_hopeless = !result.closed && is_hopeless;
    } catch (const Standard_Failure&) {
        result = {};  // not closed: the caller takes the feature as opaque and says so
    }
    result.outline = outline, result.print = print;
    result.work = most - left;
    return result;
}

}  // namespace featuremesh
