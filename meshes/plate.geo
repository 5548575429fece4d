// Plate of 200 x 50 mm; 6-node triangles, smaller towards the top, which is heated or ground.
// Lengths in mm. Made into a mesh by: gmsh -2 -format msh41 plate.geo -o plate.msh
length = 200;
height = 50;
Point(1) = {0, 0, 0, 8};
Point(2) = {length, 0, 0, 8};
Point(3) = {length, height, 0, 3};
Point(4) = {0, height, 0, 3};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1 : 4};
Plane Surface(1) = {1};

Physical Curve("bottom") = {1};
Physical Curve("right") = {2};
Physical Curve("top") = {3};
Physical Curve("left") = {4};
Physical Surface("plate") = {1};

Mesh.ElementOrder = 2;
