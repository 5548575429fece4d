// Ring of 100 and 84 mm in three jaws that press along a line each; 6-node triangles. Jaws that are points take any contact arc from the model.
// Lengths in mm. Made into a mesh by: gmsh -2 -format msh41 ring-tri6.geo -o ring-tri6.msh
outer = 50;
inner = 42;
size = 1.8;

Point(1) = {0, 0, 0};
For k In {0 : 2}
  angle = 2 * Pi * k / 3;
  Point(10 + k) = {outer * Cos(angle), outer * Sin(angle), 0, size};
  Point(20 + k) = {inner * Cos(angle), inner * Sin(angle), 0, size};
EndFor
For k In {0 : 2}
  next = (k + 1) % 3;
  Circle(10 + k) = {10 + k, 1, 10 + next};
  Circle(20 + k) = {20 + k, 1, 20 + next};
EndFor
Curve Loop(1) = {10 : 12};
Curve Loop(2) = {20 : 22};
Plane Surface(1) = {1, 2};

Physical Point("jaw-1") = {10};
Physical Point("jaw-2") = {11};
Physical Point("jaw-3") = {12};
Physical Curve("bore") = {20 : 22};
Physical Surface("ring") = {1};

Mesh.ElementOrder = 2;
