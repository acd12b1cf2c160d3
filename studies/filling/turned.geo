// A strip 200 x 100 mm turned by 30 degrees. gmsh turned.geo -2 -format msh41 -o turned.msh
c = Cos(Pi / 6); s = Sin(Pi / 6);
Point(1) = {0, 0, 0}; Point(2) = {200 * c, 200 * s, 0};
Point(3) = {200 * c - 100 * s, 200 * s + 100 * c, 0}; Point(4) = {-100 * s, 100 * c, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 3} = 9; Transfinite Curve{2, 4} = 5; Transfinite Surface{1}; Recombine Surface{1};
Physical Curve("foot") = {4}; Physical Curve("end") = {2}; Physical Surface("strip") = {1};
