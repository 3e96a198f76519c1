// SPDX-License-Identifier: MIT
// Rays meet a disc of radius 1 at 0.99 from its centre, and at 0.999.
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopoDS_Wire.hxx>
#include <ctime>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
int main()
{
    BRepBuilderAPI_MakeEdge rim(gp_Circ(gp::XOY(), 1));
    IntCurvesFace_ShapeIntersector disc;
    disc.Load(BRepBuilderAPI_MakeFace(BRepBuilderAPI_MakeWire(rim)), 1e-7);
    double seconds[2];
    for (int near = 0; near < 2; near++) {
        clock_t begun = clock();
        for (int i = 0; i < 20000; i++) {
            double from_axis = near ? 0.999 : 0.99;
            gp_Dir along(from_axis * cos(i), from_axis * sin(i), 5);
            disc.PerformNearest(gp_Lin(gp_Pnt(0, 0, -5), along), 0, 100);
        }
        seconds[near] = double(clock() - begun) / CLOCKS_PER_SEC;
    }
    bool longer = seconds[1] > 5 * seconds[0];
    printf("expected about as long, got %s\n", longer ? "over 5 times as long" : "it");
}
