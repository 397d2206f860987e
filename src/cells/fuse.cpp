// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells/fuse.h"

#include <BOPAlgo_Builder.hxx>
#include <BRep_Builder.hxx>
#include <Message_ProgressScope.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "brep/booleans/work_limit.h"
#include "brep/occt_geometry.h"
#include "brep/volumes/flux.h"
#include "cells/section_filler.h"
#include "cells/solid_splitter.h"
#include "core/errors.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/on_threads.h"
#include "core/sort_once.h"
#include "core/tolerances.h"

namespace featuremesh {

namespace {

/// A solid or a face that goes into a fuse, with everybody who owns it.
struct Source {
    TopoDS_Shape shape;
    std::vector<Owner> owners;
};

struct Sources {
    std::vector<Source> solids, faces;
    std::size_t fused =
        0;  ///< so many of the solids, the first, are pieces of an earlier fuse: they share what they touch

    void add(const FuseArgument& argument) {
        std::vector<Owner> owners;
        if (argument.owner.feature.is_valid()) owners.push_back(argument.owner);
        solids.push_back({argument.solid, owners});
        for (TopExp_Explorer it(argument.solid, TopAbs_FACE); it.More(); it.Next())
            faces.push_back({it.Current(), owners});
    }
    void add(const FusedComplex& complex) {
        for (const Cell& cell : complex.cells) solids.push_back({cell.solid, cell.owners});
        fused = solids.size();
        for (const CellFace& face : complex.faces) faces.push_back({face.face, face.owners});
    }
};

/// Runs the kernel's builder and answers what became of the solids' parts. A lone solid needs no builder.
class Builder {
  public:
    Builder(const Sources& sources, const FuseOptions& options, RunContext& context) : builder_(context) {
        const TopTools_IndexedMapOfShape different = arguments_of(sources);
        if (different.Extent() < 2) return;
        const Handle(WorkLimit) limit = new WorkLimit(options.work, context);
        filler_.pay_from(limit);
        used_ = true;
        for (int i = 1; i <= different.Extent(); ++i) {
            filler_.AddArgument(different(i));
            builder_.AddArgument(different(i));
        }
        filler_.SetNonDestructive(true);
        filler_.SetFuzzyValue(options.fuzzy);
        filler_.SetRunParallel(context.threads > 1);
        try {
            on_threads(context, [&] { perform(limit->Start()); });
        } catch (const Standard_Failure& failure) {
            trouble_ = std::string("the kernel gave up: ") + failure.GetMessageString();
        }
        is_over_limit_ = limit->is_over();
        work_ = limit->spent();
        if (is_over_limit_)
            trouble_ = "it is too much work";
        else if (trouble_.empty() && builder_.HasErrors())
            trouble_ = "the kernel could not intersect the volumes";
    }

    const std::string& trouble() const { return trouble_; }
    bool is_over_limit() const { return is_over_limit_; }
    Work work() const { return work_; }

    std::vector<TopoDS_Shape> images(const TopoDS_Shape& shape) const {
        return used_ ? builder_.images_of(shape) : std::vector<TopoDS_Shape>{shape};
    }

  private:
    /// What was fused before is one argument: the kernel does not intersect the parts of an argument with each other.
    static TopTools_IndexedMapOfShape arguments_of(const Sources& sources) {
        TopTools_IndexedMapOfShape different;
        if (sources.fused > 0) {
            const BRep_Builder builder;
            TopoDS_Compound pieces;
            builder.MakeCompound(pieces);
            for (std::size_t i = 0; i < sources.fused; ++i) builder.Add(pieces, sources.solids[i].shape);
            different.Add(pieces);
        }
        for (std::size_t i = sources.fused; i < sources.solids.size(); ++i) different.Add(sources.solids[i].shape);
        return different;
    }

    void perform(const Message_ProgressRange& range) {
        Message_ProgressScope scope(range, "fuse", 10);
        filler_.Perform(scope.Next(9));
        builder_.PerformWithFiller(filler_, scope.Next());
    }

    SectionFiller filler_;
    SolidSplitter builder_;
    bool used_ = false, is_over_limit_ = false;
    Work work_ = 0;
    std::string trouble_;
};

class Collector {
  public:
    Collector(const Sources& sources, Builder& builder, RunContext& context) : context_(context) {
        for (const Source& solid : sources.solids) add_solid(solid, builder);
        for (std::size_t c = 0; c < complex_.cells.size(); ++c) add_faces(CellId(c));
        measure();
        for (const Source& face : sources.faces) own_faces(face, builder);
        for (Cell& cell : complex_.cells) sort_once(cell.owners);
        for (CellFace& face : complex_.faces) sort_once(face.owners);
    }

    FusedComplex take() { return std::move(complex_); }

  private:
    void add_solid(const Source& source, Builder& builder) {
        for (const TopoDS_Shape& image : builder.images(source.shape))
            for (TopExp_Explorer it(image, TopAbs_SOLID); it.More(); it.Next()) {
                const int index = cell_map_.Add(it.Current());
                if (index > static_cast<int>(complex_.cells.size())) {
                    Cell cell;
                    cell.solid = TopoDS::Solid(it.Current());
                    complex_.cells.push_back(std::move(cell));
                }
                auto& owners = complex_.cells[index - 1].owners;
                owners.insert(owners.end(), source.owners.begin(), source.owners.end());
            }
    }

    void add_faces(CellId id) {
        for (TopExp_Explorer it(complex_.cells[id.index()].solid, TopAbs_FACE); it.More(); it.Next()) {
            const TopAbs_Orientation orientation = it.Current().Orientation();
            if (orientation != TopAbs_FORWARD && orientation != TopAbs_REVERSED) continue;
            const int index = face_map_.Add(it.Current());
            if (index > static_cast<int>(complex_.faces.size())) {
                CellFace face;
                face.face = TopoDS::Face(it.Current().Oriented(TopAbs_FORWARD));
                complex_.faces.push_back(std::move(face));
            }
            uses_.push_back({id, index - 1, orientation == TopAbs_FORWARD});
        }
    }

    /// Boxes, volumes and the cells beside faces; a face's share is integrated once for both of these. The kernel's
    /// pieces of a solid that was made inside out are inside out as well: they are turned.
    void measure() {
        std::vector<Box> boxes;
        Box whole;
        for (const CellFace& face : complex_.faces) whole.add(boxes.emplace_back(box_of(face.face)));
        std::vector<double> shares;
        for (const CellFace& face : complex_.faces) {
            context_.progress(0.6);
            shares.push_back(flux(face.face, whole.center()));
        }
        for (const Use& use : uses_) {
            Cell& cell = complex_.cells[use.cell.index()];
            cell.volume += use.forward ? shares[use.face] : -shares[use.face];
            cell.box.add(boxes[use.face]);
        }
        for (const Use& use : uses_) {
            const bool inside_out = complex_.cells[use.cell.index()].volume < 0;
            complex_.faces[use.face].cells[use.forward != inside_out ? 0 : 1] = use.cell;
        }
        for (Cell& cell : complex_.cells) {
            if (cell.volume < 0) cell.solid.Reverse();
            cell.volume = std::abs(cell.volume);
        }
    }

    void own_faces(const Source& face, Builder& builder) {
        if (face.owners.empty()) return;
        for (const TopoDS_Shape& image : builder.images(face.shape))
            if (const int index = face_map_.FindIndex(image); index > 0) {
                auto& owners = complex_.faces[index - 1].owners;
                owners.insert(owners.end(), face.owners.begin(), face.owners.end());
            }
    }

    struct Use {
        CellId cell;
        int face = 0;
        bool forward = true;
    };
    RunContext& context_;
    FusedComplex complex_;
    std::vector<Use> uses_;
    TopTools_IndexedMapOfShape cell_map_, face_map_;
};

/// Signed volumes of the arguments; those that were made inside out are turned, or the kernel would take all of space
/// around them for their inside.
std::vector<double> turn_outwards(std::vector<FuseArgument>& arguments, RunContext& context) {
    std::vector<double> volumes;
    for (FuseArgument& argument : arguments) {
        context.progress(0.1);
        volumes.push_back(flux(argument.solid, box_of(argument.solid).center()));
        if (volumes.back() < 0) argument.solid.Reverse();
    }
    return volumes;
}

/// Every argument is the sum of its cells, or the fuse went wrong there.
void check_arguments(FusedComplex& complex, const std::vector<FuseArgument>& arguments,
                     const std::vector<double>& volumes) {
    if (complex.cells.size() < 2) return;
    std::map<Owner, double> sums, wanted;
    for (const Cell& cell : complex.cells)
        for (const Owner& owner : cell.owners) sums[owner] += cell.volume;
    for (std::size_t i = 0; i < arguments.size(); ++i)
        if (arguments[i].owner.feature.is_valid()) wanted[arguments[i].owner] += std::abs(volumes[i]);
    for (const auto& [owner, volume] : wanted)
        if (std::abs(sums[owner] - volume) > 10 * Tolerances::volume_books * volume) complex.offenders.push_back(owner);
}

FusedComplex fuse_sources(const Sources& sources, const FuseOptions& options, RunContext& context) {
    Builder builder(sources, options, context);
    FusedComplex complex;
    if (builder.trouble().empty()) complex = Collector(sources, builder, context).take();
    complex.trouble = builder.trouble();
    complex.is_over_limit = builder.is_over_limit();
    complex.work = builder.work();
    return complex;
}

}  // namespace

FusedComplex fuse(std::vector<FuseArgument> arguments, const FuseOptions& options, RunContext& context) {
    FusedComplex complex;
    try {
        const std::vector<double> volumes = turn_outwards(arguments, context);
        Sources sources;
        for (const FuseArgument& argument : arguments) sources.add(argument);
        complex = fuse_sources(sources, options, context);
        check_arguments(complex, arguments, volumes);
    } catch (const Standard_Failure& failure) {
        complex = {};
        complex.trouble = std::string("the kernel gave up: ") + failure.GetMessageString();
    }
    return complex;
}

FusedComplex fuse_one_by_one(std::vector<FuseArgument> arguments, const FuseOptions& options, RunContext& context) {
    FusedComplex complex;
    std::vector<Owner> left_out;
    Work left = options.work;
    try {
        const std::vector<double> volumes = turn_outwards(arguments, context);
        for (const FuseArgument& argument : arguments) {
            if (left <= 0) return {{}, {}, "one by one it is too much work", true, options.work, {}};
            Sources sources;
            sources.add(complex);
            sources.add(argument);
            const FuseOptions step{options.fuzzy, std::min(left, options.work / 3)};
            FusedComplex next = fuse_sources(sources, step, context);
            left -= next.work;
            if (next.trouble.empty())
                complex = std::move(next);
            else
                left_out.push_back(argument.owner);
        }
        complex.work = options.work - left;
        check_arguments(complex, arguments, volumes);
        complex.offenders.insert(complex.offenders.end(), left_out.begin(), left_out.end());
        sort_once(complex.offenders);
    } catch (const Standard_Failure& failure) {
        complex = {};
        complex.trouble = std::string("the kernel gave up: ") + failure.GetMessageString();
    }
    return complex;
}

}  // namespace featuremesh
