// A quarter of a plate 200 x 200 mm with a hole of 20 mm: two blocks from the hole to the sides, finer
// towards the hole.
// gmsh plate.geo -2 -format msh41 -o plate.msh
Point(1) = {10, 0, 0}; Point(2) = {100, 0, 0}; Point(3) = {100, 100, 0};
Point(4) = {0, 100, 0}; Point(5) = {0, 10, 0};
Point(6) = {10 / Sqrt(2), 10 / Sqrt(2), 0}; Point(7) = {0, 0, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {5, 4}; Line(5) = {6, 3};
Circle(6) = {1, 7, 6}; Circle(7) = {6, 7, 5};
Curve Loop(1) = {1, 2, -5, -6}; Plane Surface(1) = {1};
Curve Loop(2) = {5, 3, -4, -7}; Plane Surface(2) = {2};
Transfinite Curve{1, 4, 5} = 25 Using Progression 1.11;
Transfinite Curve{2, 3, 6, 7} = 13;
Transfinite Surface{1, 2}; Recombine Surface{1, 2};
Physical Curve("bottom") = {1}; Physical Curve("right") = {2}; Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Curve("hole") = {6, 7};
Physical Surface("plate") = {1, 2};
