// A quarter of a spherical head of radius 500 mm with a radial nozzle of radius 100 mm.
R = 500; r = 100; length = 200;
z = Sqrt(R^2 - r^2); // height of the joint
Point(1) = {r, 0, z + length};
Point(2) = {r, 0, z};
Point(3) = {R, 0, 0};
Point(4) = {0, 0, 0};
Line(1) = {2, 1};
Circle(2) = {2, 4, 3};
// cells of 6 mm at the joint, which is bent over about 30 mm on the nozzle and 70 mm on the head
Transfinite Curve{1} = 15 + 1 Using Progression 1.12;
Transfinite Curve{2} = 30 + 1 Using Progression 1.075;
nozzle[] = Extrude{{0, 0, 1}, {0, 0, 0}, Pi / 2}{ Curve{1}; Layers{16}; Recombine; };
head[] = Extrude{{0, 0, 1}, {0, 0, 0}, Pi / 2}{ Curve{2}; Layers{16}; Recombine; };
ReverseMesh Surface{nozzle[1], head[1]}; // normals point outward
Physical Surface("nozzle") = {nozzle[1]};
Physical Surface("head") = {head[1]};
Physical Curve("y = 0") = {1, 2};
Physical Curve("x = 0") = {nozzle[0], head[0]};
Physical Curve("cover") = {nozzle[2]};
Physical Curve("equator") = {head[2]};
Physical Point("joint") = {2};
