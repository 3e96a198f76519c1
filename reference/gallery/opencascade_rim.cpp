// SPDX-License-Identifier: MIT
// Rays meet a disc of radius 1 at 0.99 from its centre, and at 0.999.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
int main()
{
    BRepBuilderAPI_MakeEdge rim(gp_Circ(gp::XOY(), 1));
    IntCurvesFace_ShapeIntersector disc;
    disc.Load(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(rim)), 1e-7);
    double took[2] = {}, off[2] = {0.99, 0.999};
    for (int i = 0; i < 40000; i++) {
        gp_Dir along(off[i % 2] * cos(i), off[i % 2] * sin(i), 5);
        took[i % 2] -= clock(), disc.PerformNearest(gp_Lin(gp_Pnt(0, 0, -5), along), 0, 100);
        took[i % 2] += clock();
    }
    printf("expected about as long, got %s\n", took[1] > 5 * took[0] ? "over 5 times it" : "it");
}
