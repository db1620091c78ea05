// A quarter of a plate with a circular hole, in cells that are small beside the hole.
r = 5;   // mm, radius of the hole
a = 200; // mm, half the side of the plate
SetFactory("Built-in");
Point(1) = {r, 0, 0};
Point(2) = {a, 0, 0};
Point(3) = {a, a, 0};
Point(4) = {0, a, 0};
Point(5) = {0, r, 0};
Point(6) = {0, 0, 0};
Point(7) = {2 * r, 0, 0};
Point(8) = {0, 2 * r, 0};
Line(1) = {1, 7};
Circle(2) = {7, 6, 8};
Line(3) = {8, 5};
Circle(4) = {5, 6, 1};
Line(5) = {7, 2};
Line(6) = {2, 3};
Line(7) = {3, 4};
Line(8) = {4, 8};
Curve Loop(1) = {1, 2, 3, 4};
Plane Surface(1) = {1};
Curve Loop(2) = {5, 6, 7, 8, -2};
Plane Surface(2) = {2};
// smaller cells toward the hole, at whose edge the stress changes fastest
Transfinite Curve {1} = 7 Using Progression 1.6;
Transfinite Curve {3} = 7 Using Progression 1 / 1.6;
Transfinite Curve {2, 4} = 25;
Transfinite Surface {1} = {1, 7, 8, 5};
Transfinite Curve {5} = 10 Using Progression 1.45;
Transfinite Curve {8} = 10 Using Progression 1 / 1.45;
Transfinite Curve {6, 7} = 7;
Recombine Surface {1, 2};
Mesh.RecombinationAlgorithm = 1;
Mesh.SubdivisionAlgorithm = 1;
Physical Surface("plate") = {1, 2};
Physical Curve("symmetry x") = {3, 8};
Physical Curve("symmetry y") = {1, 5};
Physical Curve("pulled") = {6};
Physical Point("top") = {5};
Physical Point("side") = {1};
