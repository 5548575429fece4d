// Ring of 100 and 84 mm in three jaws that press over 24 deg each; 8-node quadrilaterals, small cells where the jaws press.
// Lengths in mm. Made into a mesh by: gmsh -2 -format msh41 ring-quad8.geo -o ring-quad8.msh
outer = 50;
inner = 42;
jaw = 24 * Pi / 180;   // contact arc
across = 5;            // cells across the wall
under = 24;            // cells under a jaw
between = 48;          // cells from jaw to jaw

Point(1) = {0, 0, 0};
For k In {0 : 2}
  For side In {0 : 1}
    angle = 2 * Pi * k / 3 + (side - 0.5) * jaw;
    n = 2 * k + side;
    Point(10 + n) = {outer * Cos(angle), outer * Sin(angle), 0};
    Point(20 + n) = {inner * Cos(angle), inner * Sin(angle), 0};
  EndFor
EndFor
For n In {0 : 5}
  next = (n + 1) % 6;
  Circle(10 + n) = {10 + n, 1, 10 + next};
  Circle(20 + n) = {20 + n, 1, 20 + next};
  Line(30 + n) = {20 + n, 10 + n};
EndFor
For n In {0 : 5}
  next = (n + 1) % 6;
  Curve Loop(n + 1) = {30 + n, 10 + n, -(30 + next), -(20 + n)};
  Plane Surface(n + 1) = {n + 1};
  If (n % 2 == 0)
    cells = under;
  Else
    cells = between;
  EndIf
  Transfinite Curve {10 + n, 20 + n} = cells + 1;
  Transfinite Curve {30 + n} = across + 1;
  Transfinite Surface {n + 1};
  Recombine Surface {n + 1};
EndFor

Physical Curve("jaw-1") = {10};
Physical Curve("jaw-2") = {12};
Physical Curve("jaw-3") = {14};
Physical Curve("bore") = {20 : 25};
Physical Surface("ring") = {1 : 6};

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
