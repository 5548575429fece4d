// Ring of 100 and 70 mm with a keyway of 12 x 5 mm in its outside at 60 deg, in three jaws that press over 10 deg each; 6-node triangles.
// Lengths in mm. Made into a mesh by: gmsh -2 -format msh41 keyway.geo -o keyway.msh
outer = 50;
inner = 35;
jaw = 10 * Pi / 180;   // contact arc
key = 60 * Pi / 180;
width = 12;
depth = 5;
size = 2.5;

Point(1) = {0, 0, 0};
For k In {0 : 2}
  For side In {0 : 1}
    angle = 2 * Pi * k / 3 + (side - 0.5) * jaw;
    Point(10 + 2 * k + side) = {outer * Cos(angle), outer * Sin(angle), 0, 0.6 * size};
  EndFor
  Point(20 + k) = {inner * Cos(2 * Pi * k / 3), inner * Sin(2 * Pi * k / 3), 0, size};
EndFor
half = Asin(0.5 * width / outer);
bed = Sqrt(outer^2 - 0.25 * width^2) - depth;
For side In {0 : 1}
  angle = key + (2 * side - 1) * half;
  Point(30 + side) = {outer * Cos(angle), outer * Sin(angle), 0, 0.5 * size};
  off = (side - 0.5) * width;
  Point(32 + side) = {bed * Cos(key) - off * Sin(key), bed * Sin(key) + off * Cos(key), 0, 0.3 * size};
EndFor
For k In {0 : 2}
  next = (k + 1) % 3;
  Circle(10 + k) = {10 + 2 * k, 1, 11 + 2 * k};
  Circle(40 + k) = {20 + k, 1, 20 + next};
EndFor
Circle(20) = {11, 1, 30};
Line(21) = {30, 32};
Line(22) = {32, 33};
Line(23) = {33, 31};
Circle(24) = {31, 1, 12};
Circle(25) = {13, 1, 14};
Circle(26) = {15, 1, 10};
Curve Loop(1) = {10, 20, 21, 22, 23, 24, 11, 25, 12, 26};
Curve Loop(2) = {40 : 42};
Plane Surface(1) = {1, 2};

Physical Curve("jaw-1") = {10};
Physical Curve("jaw-2") = {11};
Physical Curve("jaw-3") = {12};
Physical Curve("bore") = {40 : 42};
Physical Surface("ring") = {1};

Mesh.ElementOrder = 2;
