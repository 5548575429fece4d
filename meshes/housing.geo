// Housing of 240 x 60 mm: two feet, an arch between them, two bosses with a bore of 20 mm, slopes down to a web; 6-node triangles.
// Lengths in mm. Made into a mesh by: gmsh -2 -format msh41 housing.geo -o housing.msh
size = 5;
fine = 2.5;

// From the first foot counter-clockwise.
Point(1) = {0, 0, 0, fine};
Point(2) = {40, 0, 0, fine};
Point(3) = {55, 12, 0, size};
Point(4) = {185, 12, 0, size};
Point(5) = {200, 0, 0, fine};
Point(6) = {240, 0, 0, fine};
Point(7) = {240, 60, 0, size};
Point(8) = {180, 60, 0, size};
Point(9) = {160, 35, 0, size};
Point(10) = {80, 35, 0, size};
Point(11) = {60, 60, 0, size};
Point(12) = {0, 60, 0, size};
For k In {1 : 12}
  Line(k) = {k, k % 12 + 1};
EndFor
Curve Loop(1) = {1 : 12};

For side In {0 : 1}
  x = 30 + 180 * side;
  first = 20 + 10 * side;
  Point(first) = {x, 36, 0, fine};
  Point(first + 1) = {x + 10, 36, 0, fine};
  Point(first + 2) = {x, 46, 0, fine};
  Point(first + 3) = {x - 10, 36, 0, fine};
  Point(first + 4) = {x, 26, 0, fine};
  For k In {1 : 4}
    Circle(first + k) = {first + k, first, first + k % 4 + 1};
  EndFor
  Curve Loop(2 + side) = {first + 1 : first + 4};
EndFor
Plane Surface(1) = {1, 2, 3};

Physical Curve("underside") = {1, 5};
Physical Curve("top") = {7, 9, 11};
Physical Surface("housing") = {1};
Mesh.ElementOrder = 2;
Mesh.Algorithm = 6;
