// SPDX-License-Identifier: GPL-3.0-or-later
#include "sizing/sizing_field.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <GProp_GProps.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <TopoDS_Solid.hxx>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <queue>
#include <string>

#include "brep/enclosure.h"
#include "core/errors.h"
#include "core/message.h"
#include "core/messages.h"
#include "sizing/size_provider.h"
#include "sizing/size_providers.h"
#include "sizing/source_ball.h"
#include "sizing/source_tree.h"
#include "sizing/zone_field.h"
#include "sizing/zone_notes.h"

namespace featuremesh {

/// By options and shape.
struct SizingField::Asked {
    double size, growth;
    bool may_be_coarser;                         ///< beside coarse kept nodes
    std::shared_ptr<const SizePlaces> of_shape;  ///< what it was covered with
};

struct SizingField::Data : Asked {
    explicit Data(Asked asked) : Asked(std::move(asked)) {}

    double largest = size;
    SourceTree tree;  ///< of the shape's balls, and those of sources
    SourceTree lead;  ///< how far below `largest` sizes are near coarse kept nodes; empty if there are none

    double at_most(const Vec3& p) const { return lead.empty() ? size : largest - lead.at(p); }
    /// What the balls and the zones ask for, at most `most`.
    double asked(double most, const Vec3& p) const {
        double wanted = tree.empty() ? most : std::min(most, tree.at(p));
        for (const ZoneField& zone : of_shape->zones) wanted = zone.lower(wanted, p);
        return wanted;
    }
};

namespace {

/// A kept node is a source only where its edges are this much shorter than wanted: the scatter of a good mesh is none
/// of the field's business.
constexpr double scatter_of_edge_lengths = 1.4;

}  // namespace

SizingField::SizingField(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

double SizingField::at(const Vec3& p) const { return data_->asked(data_->at_most(p), p); }
bool SizingField::is_uniform() const {
    return data_->tree.empty() && data_->lead.empty() && data_->of_shape->zones.empty();
}
SizeSource shorter_than_asked(const SizingField& field, SizeSource source) {
    if (const double asked = field.at(source.point); source.size * scatter_of_edge_lengths >= asked)
        source.size = 0.5 * asked;
    return source;
}

double SizingField::smallest() const {
    double smallest = std::min(data_->size, data_->tree.smallest());
    for (const ZoneField& zone : data_->of_shape->zones) smallest = std::min(smallest, zone.smallest());
    return smallest;
}
double SizingField::growth() const { return data_->growth; }
double SizingField::largest() const { return data_->largest; }

namespace {

/// The boxes in which a zone asks for less than `limit` in one of the two fields and for something else in the other.
/// The i-th zone of one field is compared with the i-th of the other, so a zone that was added at the end does not make
/// the others differ.
std::vector<Box> where_zones_differ(const std::vector<ZoneField>& a, const std::vector<ZoneField>& b, double limit) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
        if (i >= a.size() || i >= b.size()) {
            boxes.push_back((i < a.size() ? a : b)[i].felt_in(limit));
            continue;
        }
        const std::vector<Box> differ = where_different(a[i], b[i], limit);
        boxes.insert(boxes.end(), differ.begin(), differ.end());
    }
    return boxes;
}

}  // namespace

std::vector<Box> where_different(const SizingField& a, const SizingField& b) {
    const Box everywhere{Box{}.high, Box{}.low};
    if (a.data_->size != b.data_->size || a.data_->growth != b.data_->growth || a.data_->growth <= 1)
        return {everywhere};
    if (a.data_->largest != b.data_->largest || !balls_of_one(a.data_->lead, b.data_->lead).empty())
        return {everywhere};
    std::vector<Box> boxes = where_zones_differ(a.data_->of_shape->zones, b.data_->of_shape->zones, a.data_->largest);
    for (const SourceBall& ball : balls_of_one(a.data_->tree, b.data_->tree)) {
        Box box;
        box.add(ball.center);
        boxes.push_back(box.grown(ball.radius + (a.data_->largest - ball.size) / (a.data_->growth - 1)));
    }
    constexpr std::size_t few = 16;
    if (boxes.size() <= few) return boxes;
    Box together;
    for (const Box& box : boxes) together.add(box);
    return {together};
}

namespace {

/// Tets per cube of the edge length, as the volume step makes them (measured on parts with 5 000 to 350 000 tets).
constexpr double tets_per_cube = 7.1, most_tets_per_cube = 10;
/// Corrections of that estimate, measured on the examples. Per square of the edge length on the boundary there are
/// `fewer_per_square` tets less, but at least `least_per_square` in parts thinner than the edge length. For each tet
/// that a finer place adds, the growth of sizes around it brings the total to `of_finer`.
constexpr double fewer_per_square = 0.7, least_per_square = 3.5, of_finer = 1.25;

constexpr double least_extent = 1e-3;  // mm: ten thousand times the kernel's own tolerance

double longest_extent(const Box& box) {
    const Vec3 size = box.size();
    return std::max({size.x, size.y, size.z});
}

void check_size(double size, const Box& part) {
    const Extent extent{part.size()};
    if (longest_extent(part) < least_extent) throw InputError(say<Code::part_too_small>(extent));
    if (!std::isfinite(size) || size <= 0) throw InputError(say<Code::size_not_positive>(Length{size}, extent));
    if (size > longest_extent(part) * (1 + 1e-9))
        throw InputError(say<Code::size_larger_than_part>(Length{size}, extent));
}

void check_options(const SizingOptions& options, const Box& part) {
    check_size(options.size, part);
    if (!std::isfinite(options.min_size) || options.min_size < 0 || options.min_size > options.size)
        throw InputError(say<Code::smallest_size_out_of_range>(Length{options.min_size}, Length{options.size}));
    if (!std::isfinite(options.growth) || options.growth < 1)
        throw InputError(say<Code::growth_below_one>(options.growth));
    if (!std::isfinite(options.elements_per_circle) || options.elements_per_circle < 0)
        throw InputError(say<Code::negative_per_circle>(options.elements_per_circle));
    if (!std::isfinite(options.elements_across_gap) || options.elements_across_gap < 0)
        throw InputError(say<Code::negative_across_gaps>(options.elements_across_gap));
    for (const SizeZone& zone : options.zones) check_zone(zone);
    for (const LocalSize& local : options.local)
        if (!std::isfinite(local.size) || local.size <= 0)
            throw InputError(say<Code::local_size_not_positive>(local.entity, Length{local.size}));
}

/// Near kept nodes whose mesh is clearly coarser than the global size, the field may exceed the global size.
void lead_above(std::span<const SizeSource> kept, double slope, SizingField::Data& data) {
    std::vector<SourceBall> coarse;
    for (const SizeSource& source : kept)
        if (source.size > scatter_of_edge_lengths * data.size)
            coarse.push_back({source.point, source.size, source.size});
    if (coarse.empty() || slope <= 0) return;
    for (const SourceBall& ball : coarse) data.largest = std::max(data.largest, ball.size);
    for (SourceBall& ball : coarse) ball.size = data.largest - ball.size;
    data.lead = SourceTree(std::move(coarse), slope, data.largest - data.size);
}

/// Adds the kept nodes whose mesh is clearly finer than the field asks for.
void add_kept(std::span<const SizeSource> kept, const SizingField::Data& field, std::vector<SourceBall>& sources) {
    for (const SizeSource& source : kept) {
        if (!(source.size > 0) || source.size * scatter_of_edge_lengths >= field.size) continue;
        if (source.size * scatter_of_edge_lengths < field.asked(no_size, source.point))
            sources.push_back({source.point, 0, source.size});
    }
}

SizingField field_of(const SizingField::Asked& asked, std::span<const SizeSource> sources) {
    auto data = std::make_shared<SizingField::Data>(asked);
    const double slope = asked.growth - 1;
    data->largest = asked.size;
    if (asked.may_be_coarser) lead_above(sources, slope, *data);
    std::vector<SourceBall> balls = asked.of_shape->balls;
    data->tree = SourceTree(balls, slope, data->largest);
    add_kept(sources, *data, balls);
    if (balls.size() > asked.of_shape->balls.size()) data->tree = SourceTree(std::move(balls), slope, data->largest);
    return SizingField(std::move(data));
}

}  // namespace

SizingField make_sizing(const Brep& brep, const SizingOptions& options, std::span<const SizeSource> sources,
                        RunContext& context) {
    check_options(options, brep.box());
    context.check_cancelled();
    SizingOptions asked = options;
    if (brep.solid_count() == 1)
        for (const LocalSize& local : options.local)
            if (local.entity == entity_of(SolidId(0))) asked.size = std::min(asked.size, local.size);
    return field_of({asked.size, asked.growth, asked.size == options.size,
                     std::make_shared<const SizePlaces>(cover_shape(brep, asked, context))},
                    sources);
}

SizingField with_sources(const SizingField& field, std::span<const SizeSource> sources) {
    return field_of(*field.data_, sources);
}

namespace {

Box octant_of(const Box& box, unsigned octant) {
    const Vec3 half = box.size() * 0.5;
    const Vec3 low{box.low.x + (octant & 1 ? half.x : 0), box.low.y + (octant & 2 ? half.y : 0),
                   box.low.z + (octant & 4 ? half.z : 0)};
    return {low, low + half};
}

/// A cube of space and how many more tets than at the global size it would have if it were all material.
struct Cell {
    std::uint32_t way;  ///< down to it: three bits for the octant at each depth, the first one in front
    Vec3 center;
    double extra;
};

/// Halves cells until the field hardly changes within one; cells at the global size have nothing extra.
class CellCollector {
  public:
    CellCollector(const Box& box, const SizingField& sizing, const RunContext& context)
        : box_(box), sizing_(sizing), slope_(sizing.growth() - 1), watch_(context) {}

    /// Depth by depth, as deep as so many looks allow: a size far too small would be halved down to for minutes.
    /// Neighbours are near one another in the list.
    std::vector<Cell> collect() {
        constexpr std::size_t most_looks = 1 << 21;
        std::vector<std::uint32_t> ways{0};
        std::size_t looks = 1;
        for (int depth = 0; !ways.empty(); ++depth) {
            const std::vector<Look> coarse = look_at(ways, depth);
            ways.clear();
            if (depth < deepest && looks + 8 * coarse.size() < most_looks)
                for (const Look& look : coarse)
                    for (std::uint32_t octant = 0; octant < 8; ++octant)
                        ways.push_back(look.way | octant << shift_at(depth));
            else
                for (const Look& look : coarse) add(look, depth);
            looks += ways.size();
        }
        std::sort(cells_.begin(), cells_.end(), [](const Cell& a, const Cell& b) { return a.way < b.way; });
        return std::move(cells_);
    }

  private:
    static constexpr int deepest = 9;
    struct Look {
        std::uint32_t way;
        double h;
    };

    static int shift_at(int depth) { return 3 * (deepest - 1 - depth); }

    Box box_at(std::uint32_t way, int depth) const {
        Box box = box_;
        for (int d = 0; d < depth; ++d) box = octant_of(box, way >> shift_at(d) & 7);
        return box;
    }

    /// Those in which the field changes; the others are added.
    std::vector<Look> look_at(const std::vector<std::uint32_t>& ways, int depth) {
        std::vector<Look> coarse;
        for (const std::uint32_t way : ways) {
            watch_();
            const Box box = box_at(way, depth);
            const double h = sizing_.at(box.center()), reach = slope_ * 0.5 * box.diagonal();
            if (reach > 0.3 * h && h - reach < sizing_.largest())
                coarse.push_back({way, h});
            else
                add({way, h}, depth);
        }
        return coarse;
    }

    void add(const Look& look, int depth) {
        const Box box = box_at(look.way, depth);
        const double size = sizing_.largest();
        const Vec3 s = box.size();
        const double extra = s.x * s.y * s.z * (1 / (look.h * look.h * look.h) - 1 / (size * size * size));
        if (extra > 0) cells_.push_back({look.way, box.center(), extra});
    }

    const Box box_;
    const SizingField& sizing_;
    const double slope_;
    RoundWatch watch_;
    std::vector<Cell> cells_;
};

/// Classifies cells drawn at equal steps of the summed extra tets; a finer cell is drawn more often.
double share_inside(const Brep& brep, const std::vector<Cell>& cells, double total, const RunContext& context) {
    constexpr int draws = 256;
    std::vector<TopoDS_Shape> solids;
    for (std::size_t s = 0; s < brep.solid_count(); ++s) solids.push_back(brep.solid(SolidId(s)));
    const Enclosure enclosure(solids);  // the kernel's classifier takes half a second a point where faces are threads
    int inside = 0, drawn = 0;
    double sum = 0;
    for (const Cell& cell : cells) {
        sum += cell.extra;
        const int due = static_cast<int>(std::floor(sum / total * draws + 0.5));
        if (due <= drawn) continue;
        context.check_cancelled();
        if (enclosure.contains(cell.center)) inside += due - drawn;
        drawn = due;
    }
    return drawn > 0 ? double(inside) / drawn : 1.0;
}

/// A box of space with no more tets than `most_tets` in it.
struct Bounded {
    Box box;
    double most_tets;
    bool operator<(const Bounded& other) const { return most_tets < other.most_tets; }
};

Bounded bounded(const Box& box, const SizingField& sizing) {
    const double reach = (sizing.growth() - 1) * 0.5 * box.diagonal();
    const double h = std::max(sizing.smallest(), sizing.at(box.center()) - reach);
    const Vec3 s = box.size();
    return {box, most_tets_per_cube * s.x * s.y * s.z / (h * h * h)};
}

}  // namespace

bool may_ask_for_more_tets(const Brep& brep, const SizingField& sizing, double most) {
    constexpr int most_looks = 1 << 16;
    std::priority_queue<Bounded> boxes;  // the worst is halved in all directions
    boxes.push(bounded(brep.box(), sizing));
    double sum = boxes.top().most_tets;
    for (int looks = 0; !(sum <= most) && looks < most_looks; looks += 8) {  // no number: more than can be counted
        const Bounded worst = boxes.top();
        boxes.pop();
        sum -= worst.most_tets;
        for (unsigned octant = 0; octant < 8; ++octant) {
            const Bounded part = bounded(octant_of(worst.box, octant), sizing);
            sum += part.most_tets;
            boxes.push(part);
        }
    }
    return !(sum <= most);
}

namespace {

/// Of the faces of solids, mm^2.
double area_of_boundary(const Brep& brep) {
    double sum = 0;
    for (std::size_t f = 0; f < brep.face_count(); ++f) {
        if (!brep.is_meshed(FaceId(f)) || brep.is_free(FaceId(f))) continue;
        GProp_GProps area;
        BRepGProp::SurfaceProperties(brep.face(FaceId(f)), area);
        sum += area.Mass();
    }
    return sum;
}

}  // namespace

double estimate_tets(const Brep& brep, const SizingField& sizing, const RunContext& context, double few) {
    const double size = sizing.largest(), squares = area_of_boundary(brep) / (size * size);
    const double uniform = std::max(tets_per_cube * brep.volume() / (size * size * size) - fewer_per_square * squares,
                                    least_per_square * squares);
    double finer = 0;  // cubes more
    if (!sizing.is_uniform()) {
        const std::vector<Cell> cells = CellCollector(brep.box(), sizing, context).collect();
        double extra = 0;
        for (const Cell& cell : cells) extra += cell.extra;
        const double if_all_inside = uniform + of_finer * tets_per_cube * extra;
        if (if_all_inside <= few) return if_all_inside;
        if (extra > 0) finer = extra * share_inside(brep, cells, extra, context);
    }
    return uniform + of_finer * tets_per_cube * finer;
}

namespace {

/// The face's area over that of the triangles wanted there, as the mean of points over its parameters tells.
double estimate_triangles(const TopoDS_Face& face, const SizingField& sizing) {
    constexpr int points_across = 12;
    const double of_unit_side = std::sqrt(3.0) / 4;
    GProp_GProps area;
    BRepGProp::SurfaceProperties(face, area);
    const BRepAdaptor_Surface surface(face);
    double first_u, last_u, first_v, last_v, weights = 0, wanted = 0;
    BRepTools::UVBounds(face, first_u, last_u, first_v, last_v);
    for (int i = 0; i < points_across; ++i)
        for (int j = 0; j < points_across; ++j) {
            gp_Pnt point;
            gp_Vec du, dv;
            surface.D1(first_u + (last_u - first_u) * (i + 0.5) / points_across,
                       first_v + (last_v - first_v) * (j + 0.5) / points_across, point, du, dv);
            const double weight = du.Crossed(dv).Magnitude(), h = sizing.at({point.X(), point.Y(), point.Z()});
            weights += weight, wanted += weight / (of_unit_side * h * h);
        }
    return weights > 0 ? area.Mass() * wanted / weights : 0;
}

double estimate_segments(const TopoDS_Edge& edge, const SizingField& sizing) {
    constexpr int points_along = 100;
    const BRepAdaptor_Curve curve(edge);
    const double step = (curve.LastParameter() - curve.FirstParameter()) / points_along;
    double sum = 0;
    for (int i = 0; i < points_along; ++i) {
        gp_Pnt point;
        gp_Vec along;
        curve.D1(curve.FirstParameter() + (i + 0.5) * step, point, along);
        sum += along.Magnitude() * step / sizing.at({point.X(), point.Y(), point.Z()});
    }
    return sum;
}

}  // namespace

double estimate_elements(const Brep& brep, const SizingField& sizing, const RunContext& context, double few) {
    double sum = brep.solid_count() > 0 ? estimate_tets(brep, sizing, context, few) : 0;
    for (std::size_t f = 0; f < brep.face_count(); ++f)
        if (brep.is_free(FaceId(f))) sum += estimate_triangles(brep.face(FaceId(f)), sizing);
    for (std::size_t e = 0; e < brep.edge_count(); ++e)
        if (brep.is_free(EdgeId(e)) && !brep.is_degenerated(EdgeId(e)))
            sum += estimate_segments(brep.edge(EdgeId(e)), sizing);
    return sum;
}

}  // namespace featuremesh
