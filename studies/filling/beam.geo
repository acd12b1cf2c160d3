// A beam of 200 mm whose section 100 x 60 mm is skewed by 20 mm. gmsh beam.geo -3 -format msh41 -o beam.msh
Point(1) = {0, 0, 0}; Point(2) = {0, 100, 0}; Point(3) = {0, 120, 60}; Point(4) = {0, 20, 60};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 3} = 6; Transfinite Curve{2, 4} = 4; Transfinite Surface{1}; Recombine Surface{1};
out[] = Extrude {200, 0, 0} { Surface{1}; Layers{10}; Recombine; };
Physical Volume("beam") = {out[1]}; Physical Surface("foot") = {1}; Physical Surface("end") = {out[0]};
