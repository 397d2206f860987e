// SPDX-License-Identifier: GPL-3.0-or-later
#include "brep/face_probe.h"

#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <ElSLib.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>

#include "brep/face_trim.h"
#include "brep/occt_geometry.h"
#include "brep/solid_probe.h"

namespace featuremesh {

struct FaceProbe::Data {
    TopoDS_Face face;
    std::optional<Box> box;
    BRepAdaptor_Surface surface;
    FaceTrim trim;
    Handle(ShapeAnalysis_Surface) free_form;
    std::optional<std::optional<Vec3>> inner_point;

    explicit Data(const TopoDS_Face& f) : face(f), surface(f, false), trim(f) {}

    gp_Pnt2d nearest_parameters(const gp_Pnt& p) {
        double u = 0, v = 0;
        switch (surface.GetType()) {
            case GeomAbs_Plane:
                ElSLib::Parameters(surface.Plane(), p, u, v);
                break;
            case GeomAbs_Cylinder:
                ElSLib::Parameters(surface.Cylinder(), p, u, v);
                break;
            case GeomAbs_Cone:
                ElSLib::Parameters(surface.Cone(), p, u, v);
                break;
            case GeomAbs_Sphere:
                ElSLib::Parameters(surface.Sphere(), p, u, v);
                break;
            case GeomAbs_Torus:
                ElSLib::Parameters(surface.Torus(), p, u, v);
                break;
            default:
                if (free_form.IsNull()) {
                    free_form = new ShapeAnalysis_Surface(BRep_Tool::Surface(face));
                    // Extrusions and other unbounded surfaces have no bounds of their own to search in.
                    double u1 = 0, u2 = 0, v1 = 0, v2 = 0;
                    BRepTools::UVBounds(face, u1, u2, v1, v2);
                    free_form->SetDomain(u1, u2, v1, v2);
                }
                return free_form->ValueOfUV(p, Precision::Confusion());
        }
        return {u, v};
    }
};

FaceProbe::FaceProbe(const TopoDS_Face& face) : data_(std::make_unique<Data>(face)) {}
FaceProbe::~FaceProbe() = default;
FaceProbe::FaceProbe(FaceProbe&&) noexcept = default;
FaceProbe& FaceProbe::operator=(FaceProbe&&) noexcept = default;

const Box& FaceProbe::box() const {
    if (!data_->box) data_->box = box_of(data_->face);
    return *data_->box;
}

double FaceProbe::distance_to_surface(const Vec3& p) const {
    const gp_Pnt point = to_pnt(p);
    const gp_Pnt2d uv = data_->nearest_parameters(point);
    return data_->surface.Value(uv.X(), uv.Y()).Distance(point);
}

bool FaceProbe::contains(const Vec3& p, double tolerance) const {
    if (!box().grown(tolerance).contains(p)) return false;
    const gp_Pnt point = to_pnt(p);
    const gp_Pnt2d uv = data_->nearest_parameters(point);
    if (data_->surface.Value(uv.X(), uv.Y()).Distance(point) > tolerance) return false;
    return contains(uv.X(), uv.Y());
}

bool FaceProbe::contains(double u, double v) const { return data_->trim.has(u, v); }

Vec3 FaceProbe::normal_at(const Vec3& p) const {
    const gp_Pnt2d uv = data_->nearest_parameters(to_pnt(p));
    return outward_normal(data_->surface, data_->face, uv.X(), uv.Y());
}

const std::optional<Vec3>& FaceProbe::inner_point() const {
    if (!data_->inner_point) {
        const auto found = point_on(data_->face);
        data_->inner_point = found ? std::optional<Vec3>(found->point) : std::nullopt;
    }
    return *data_->inner_point;
}

}  // namespace featuremesh
