// A panel of 480 x 360 mm with three blades of 30 mm along x.
lx = 480; ly = 360; height = 30;
n = 32; // cells along x
y[] = {0, 60, 180, 300, ly};
For i In {0:4}
  Point(10 + i) = {0, y[i], 0};
  Point(20 + i) = {lx, y[i], 0};
  Line(10 + i) = {10 + i, 20 + i};
  Transfinite Curve{10 + i} = n + 1;
EndFor
For i In {0:3}
  Line(20 + i) = {10 + i, 11 + i};
  Line(30 + i) = {20 + i, 21 + i};
  Transfinite Curve{20 + i, 30 + i} = (i == 0 || i == 3 ? 4 : 8) + 1;
  Curve Loop(40 + i) = {10 + i, 30 + i, -(11 + i), -(20 + i)};
  Plane Surface(40 + i) = {40 + i};
EndFor
For i In {1:3}
  Point(50 + i) = {0, y[i], height};
  Point(60 + i) = {lx, y[i], height};
  Line(50 + i) = {50 + i, 60 + i};
  Line(60 + i) = {10 + i, 50 + i};
  Line(70 + i) = {20 + i, 60 + i};
  Transfinite Curve{50 + i} = n + 1;
  Transfinite Curve{60 + i, 70 + i} = 2 + 1;
  Curve Loop(80 + i) = {10 + i, 70 + i, -(50 + i), -(60 + i)};
  Plane Surface(80 + i) = {80 + i};
EndFor
Transfinite Surface "*";
Mesh.RecombineAll = 1;
Physical Surface("skin") = {40:43};
Physical Surface("blades") = {81:83};
Physical Curve("start") = {20:23};
Physical Curve("end") = {30:33};
Physical Curve("start of blades") = {61:63};
Physical Curve("end of blades") = {71:73};
Physical Curve("sides") = {10, 14};
Physical Curve("feet") = {11:13};
Physical Point("corner") = {10};
