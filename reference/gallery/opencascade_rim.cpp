// SPDX-License-Identifier: MIT
// Rays meet a disc of radius 1 at 0.99 from its centre, and at 0.999.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS_Wire.hxx>
int main()
{
    BRepBuilderAPI_MakeEdge rim(gp_Circ(gp::XOY(), 1));
    IntCurvesFace_ShapeIntersector disc;
    disc.Load(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(rim)), 1e-7);
    double least[2] = {1e9, 1e9}, off[2] = {0.99, 0.999}, start = 0;
    for (int i = 0, kind = 0; i < 40000; kind = ++i / 100 % 2) {
        start = i % 100 == 0 ? clock() : start;
        gp_Dir along(off[kind] * cos(i), off[kind] * sin(i), 5);
        disc.PerformNearest(gp_Lin(gp_Pnt(0, 0, -5), along), 0, 100);
        least[kind] = i % 100 == 99 ? fmin(least[kind], clock() - start) : least[kind];
    }
    printf("expected about as long, got %s\n", least[1] > 5 * least[0] ? "over 5 times it" : "it");
}
