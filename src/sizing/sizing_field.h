// SPDX-License-Identifier: GPL-3.0-or-later
// The wanted edge length at a point.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brep/brep.h"
#include "core/geometry.h"
#include "core/ids.h"
#include "core/run_context.h"
#include "sizing/size_zone.h"
#include "sizing/source_ball.h"

namespace featuremesh {

struct LocalSize {
    Entity entity;    ///< face, edge, vertex or solid of the final shape
    double size = 0;  ///< mm
    bool operator==(const LocalSize&) const = default;
};

struct SizingOptions {
    double size = 0;                   ///< mm, everywhere at most this, but for coarser sources
    double min_size = 0;               ///< mm, curvature and gaps ask for nothing below it
    double elements_per_circle = 12;   ///< curvature; 0 is off
    double elements_across_gap = 0;    ///< thin walls; 0 is off
    bool refines_narrow_faces = true;  ///< those far narrower than the size
    double pieces_round_rod = 6;       ///< round what is thinner than the sizes; four leave out 36 % of a rod, six 17 %
    double growth = 1.3;  ///< neighbouring edge lengths differ at most by this factor: |h(x)-h(y)| <= (growth-1) |x-y|
    std::vector<LocalSize> local;
    std::vector<SizeZone> zones;
    std::vector<SourceBall> balls;  ///< with a size of its own in each, as an estimate of the error asks
    bool operator==(const SizingOptions&) const = default;
};

/// A kept node's actual edge length. Where it is clearly below what the field asks for (by more than the scatter of a
/// good mesh, 1.4), the field equals it there and grows from it; where it is as clearly above the global size, the
/// field may be as coarse there, and less so around, unless the shape asks for less. Elsewhere the field stays as it
/// is, so that an update does not follow the scatter of the mesh it updates.
struct SizeSource {
    Vec3 point;
    double size = 0;
};

/// Immutable, safe to query from several threads, below a microsecond a query on average.
class SizingField {
  public:
    double at(const Vec3& p) const;
    bool is_uniform() const;
    double smallest() const;
    double largest() const;
    /// As in SizingOptions.
    double growth() const;
    /// Boxes outside of which both fields are equal; one that holds all space where they are of different kinds.
    friend std::vector<Box> where_different(const SizingField& a, const SizingField& b);
    friend SizingField with_sources(const SizingField& field, std::span<const SizeSource> sources);

    struct Asked;
    struct Data;
    explicit SizingField(std::shared_ptr<const Data> data);

  private:
    std::shared_ptr<const Data> data_;
};

std::vector<Box> where_different(const SizingField& a, const SizingField& b);

/// Throws InputError for a size that is zero, negative, or larger than the part.
SizingField make_sizing(const Brep& brep, const SizingOptions& options, std::span<const SizeSource> sources,
                        RunContext& context);
/// The field of the same shape and options with these sources in place of its own; the shape is not looked at again.
SizingField with_sources(const SizingField& field, std::span<const SizeSource> sources);

/// The source as it is where it asks for so much less than the field that it is felt (less than 1 / 1.4 of that), else
/// with half of what the field asks for: a field with it is another one.
SizeSource shorter_than_asked(const SizingField& field, SizeSource source);

/// False where the field asks for at most `most` tets in all of the part's box, which few looks at it mostly tell.
bool may_ask_for_more_tets(const Brep& brep, const SizingField& sizing, double most);
/// About how many tets the field asks for in the part (used to refuse more than 50 million, and by the task panel). Up
/// to `few` it may be a number that is too large, which takes no look at the shape.
double estimate_tets(const Brep& brep, const SizingField& sizing, const RunContext& context = {}, double few = 0);
/// The same of what the part is meshed with: tets, or triangles, or segments.
double estimate_elements(const Brep& brep, const SizingField& sizing, const RunContext& context = {}, double few = 0);

}  // namespace featuremesh
