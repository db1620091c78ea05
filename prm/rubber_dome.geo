// The top of a sphere of radius 100 mm, 20 mm high.
SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, -80, 100, Asin(0.8), Pi / 2, 2 * Pi};
Physical Surface("dome") = {1};
Physical Curve("base") = {3};
Physical Point("top") = {1};
Mesh.MeshSizeMin = 10; // mm
Mesh.MeshSizeMax = 10;
// quadrilaterals alone: halves of larger ones, and thirds of the triangles that are left
Mesh.RecombineAll = 1;
Mesh.RecombinationAlgorithm = 1;
Mesh.SubdivisionAlgorithm = 1;
