/* SPDX-License-Identifier: MIT */
/* Open CASCADE Technology, the modelling kernel of FreeCAD and others: the faces of a BRepPrimAPI
 * solid and a line by IntCurvesFace_ShapeIntersector
 * (https://dev.opencascade.org/doc/refman/html/class_int_curves_face___shape_intersector.html).
 *
 *     unit, local    a gp_Lin has a gp_Dir; primitives stand on the xy plane, their axis is z
 *     segment        PerformNearest's interval of parameters
 *     scale          the tolerance, Precision::Confusion(), is an absolute length, 1e-7 */
#include "library.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>

const char sure_candidate_entry[] = "unit local segment scale=0.1..1e6";

struct body {
    std::unique_ptr<IntCurvesFace_ShapeIntersector> faces;
    explicit body(const TopoDS_Shape &shape) : faces(new IntCurvesFace_ShapeIntersector)
    {
        faces->Load(shape, Precision::Confusion());
    }
    int meet(const real *ray, peer_hit *hit) const
    {
        gp_Lin line(gp_Pnt(ray[0], ray[1], ray[2]), gp_Dir(ray[3], ray[4], ray[5]));
        faces->PerformNearest(line, 0, ray[7]);
        return found_at(ray, faces->NbPnt() > 0 ? faces->WParameter(1) : NAN, hit);
    }
};
ANSWER_BY(sphere, body, BRepPrimAPI_MakeSphere(n[3]))
ANSWER_BY(cylinder, body, BRepPrimAPI_MakeCylinder(n[6], n[5]))
ANSWER_BY(cone, body, BRepPrimAPI_MakeCone(n[6], 0, n[5]))
ANSWER_BY(box, body, BRepPrimAPI_MakeBox(n[3], n[4], n[5]))
