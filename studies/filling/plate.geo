// A quarter of a plate 200 x 200 mm with a hole of 20 mm, even quadrilaterals of about 2 mm. gmsh plate.geo -2 -o plate.msh
SetFactory("Built-in");
h = 2.0;
Point(1) = {10, 0, 0, h};
Point(2) = {100, 0, 0, h};
Point(3) = {100, 100, 0, h};
Point(4) = {0, 100, 0, h};
Point(5) = {0, 10, 0, h};
Point(6) = {0, 0, 0, h};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 5};
Circle(5) = {5, 6, 1};
Curve Loop(1) = {1, 2, 3, 4, 5};
Plane Surface(1) = {1};
Mesh.Algorithm = 8;               // Frontal-Delaunay for quads
Mesh.RecombinationAlgorithm = 3;  // Blossom full-quad
Mesh.RecombineAll = 1;
Mesh.MshFileVersion = 4.1;
Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Curve("hole") = {5};
Physical Surface("plate") = {1};
