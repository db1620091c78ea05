// SPDX-License-Identifier: LGPL-2.1-or-later

// Every entry that the program declares refuses values of the wrong type or out
// of range with one sentence that names the file, the entry, its value and what
// is allowed.

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <biface/input/entry_declarations.h>
#include <biface/problem/parameters.h>
#include <biface/program/program.h>
#include <biface/stepping/stiffness_of_motions.h>

#include "../tests.h"
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

using namespace dealii;

namespace
{
  const std::string long_word(20000, 'x');

  /** Entries whose value is any text: names. An empty one means none. */
  const std::set<std::string> any_text{"Output/Directory"};

  /** Settings beside the wrong value, without which it would not be looked
   * at. */
  using Settings = std::map<std::string, std::string>;

  struct Wrong
  {
    std::vector<std::string> values;
    Settings                 others = {};
  };

  const std::vector<std::string> wrong_lists{"x",
                                             "1, two",
                                             "1:2",
                                             "1:2:1",
                                             "1:2:2.5",
                                             "1:2:3:4",
                                             "1:2:100000",
                                             "nan",
                                             "1e999"};

  const Settings cords_in_rubber{{"Material rubber/Type", "cord and rubber"},
                                 {"Material rubber/E_cord", "2400"},
                                 {"Material rubber/E_rubber", "6"},
                                 {"Material rubber/Cord diameter", "0.6"},
                                 {"Material rubber/Cord pitch", "1"}};

  Settings
  rubber(const std::string &type, const Settings &others)
  {
    Settings settings{{"Material rubber/Type", type},
                      {"Material rubber/E", "0"},
                      {"Material rubber/nu", "0"}};
    settings.insert(others.begin(), others.end());
    return settings;
  }

  const Settings in_motion{{"Stage 1/Inertia", "true"},
                           {"Stage 1/Duration", "1"},
                           {"Material rubber/Density", "1"}};

  const Settings shaken{{"Stage 1/Frequency response", "1"},
                        {"Stage 1/Excitations", "load factor"},
                        {"Material rubber/Density", "1"}};

  const Settings cords_in_neo_Hooke{
    {"Material rubber/Type", "transversely isotropic"},
    {"Material rubber/Matrix", "neo-Hooke"},
    {"Material rubber/E_L", "100"},
    {"Material rubber/G_LT", "1"}};

  // the lists 'Springs', 'Dampers' and 'Masses'
  const std::vector<Wrong> suspensions_of_supports{
    {{"supports: 1", "supports"}},
    {{"supports",
      "supports: x",
      "supports: nan",
      "supports: -1",
      "supports alpha_1 max: 1",
      "supports: 1, supports: 2"},
     {{"Supports/alpha_1 min", "x both = 1"}}}};
  const std::vector<Wrong> suspensions_of_bodies{
    {{"up",
      "up:",
      "up: x",
      "up: nan",
      "up: 1e999",
      "up: -1",
      ": 1",
      "down: 1",
      "up: 1, up: 2"},
     {{"Body bar/Motions", "up: 1 0 0"}}}};

  /** What is wrong for entries that the program reads as a text, and what is
   * out of range for those it reads as a number. */
  const std::map<std::string, std::vector<Wrong>> by_name{
    {"Surface/Circular arc/Radius", {{{"0", "-0", "-1"}}}},
    {"Surface/Circular arc/Center radius", {{{"-1"}}}},
    {"Surface/Cord equilibrium/Crown radius",
     {{{"0", "-1"}, {{"Surface/Meridian", "cord equilibrium"}}}}},
    {"Surface/Cord equilibrium/Half width",
     {{{"0", "-1", "0.0001", "1000"},
       {{"Surface/Meridian", "cord equilibrium"}}}}},
    {"Surface/Cord equilibrium/End radius",
     {{{"0", "-1", "250", "1"}, {{"Surface/Meridian", "cord equilibrium"}}}}},
    {"Surface/Cord equilibrium/Crown cord angle",
     {{{"0", "-38", "91", "from end half width"},
       {{"Surface/Meridian", "cord equilibrium"}}}}},
    {"Surface/Cord equilibrium/End half width",
     {{{"40"}, {{"Surface/Meridian", "cord equilibrium"}}},
      {{"0", "-1", "49.99", "1000"},
       {{"Surface/Meridian", "cord equilibrium"},
        {"Surface/Cord equilibrium/Crown cord angle",
         "from end half width"}}}}},
    {"Surface/Mesh/File",
     {{{"", "no_such_file.msh", "/", long_word}, {{"Surface/Type", "mesh"}}}}},
    {"Surface/Mesh/Merge distance",
     {{{"-1"},
       {{"Surface/Type", "mesh"},
        {"Surface/Mesh/File", PRM_DIR "/rubber_dome.msh"}}}}},
    {"Surface/Mesh/Geometry", {{{"x +", "1, 2", "alpha_1"}}}},
    {"Surface/Mesh/Geometry file",
     {{{"no_such_file.step", "/", long_word},
       {{"Surface/Type", "mesh"},
        {"Surface/Mesh/File", PRM_DIR "/rubber_dome.msh"}}}}},
    {"Surface/Mesh/Direction", {{{"1", "1; 0", "1; 0; 0; 0", "1; 0; q"}}}},
    {"Surface/Mesh/Joints",
     {{{"fold",
        "fold: stiff",
        "fold: -1",
        "fold: 0",
        "fold: nan",
        "fold: hinge, fold: rigid"}}}},
    {"Surface/Spline/File",
     {{{"", "no_such_file.csv", "/", long_word},
       {{"Surface/Meridian", "spline"}}}}},
    {"Surface/Imperfection/Formula",
     {{{"", "r", "end", "x +", "1, 2", "1/(x-x)", "sqrt(-1)", "1e999"}}}},
    {"Surface/Imperfection/Tables",
     {{{"t",
        ":file",
        "t:",
        "x: file",
        "t: file, t: file",
        "2: file",
        "_t: file"}},
      {{"t: no_such_file.csv", "t: /"},
       {{"Surface/Imperfection/Formula", "t"}}}}},
    {"Surface/Imperfection/Fourier series",
     {{{"t", ":file", "t:", "x: file", "t: file, t: file", "2: file"}},
      {{"t: no_such_file.csv", "t: /"},
       {{"Surface/Imperfection/Formula", "t"}}}}},
    {"Mesh/Intervals alpha_1",
     {{{"",
        "a",
        "0",
        "0:1",
        "0:1:2:3:4",
        "0:0:4",
        "1:0:4",
        "0:1:0",
        "0:1:-1",
        "0:1:1.5",
        "0:1:1e9",
        "0:1:4e9",
        "nan:1:2",
        "0:inf:2",
        "0:1:2:0",
        "0:1:2:x",
        "0:1:1000001",
        "0:1e999:2",
        "0:0x10:2",
        "0:1:2:smooth",
        "0:1:2,2:3:1",
        "0:2:2,1:3:1",
        "-300:0:4",
        "0:2*end:4",
        "end:0:4",
        "0:end",
        "0:ends:4",
        "0:1/(end-180):4",
        "-end:0:4, 0.1*end:end:4",
        "0:1:600000,1:2:600000"}},
      {{"-120:120:1000000"}, {{"Mesh/Intervals alpha_2", "-180:180:290"}}}}},
    {"Mesh/Intervals alpha_2",
     {{{"",
        "0:361:4",
        "0:360:2",
        "0:359:4",
        "0:360:nan",
        "0:360:4:-1",
        "0:end:4"}}}},
    {"Units", {{{"mm", "mm, N", "mm, N, s, kg", "mm, N,", "m m, N, s", "<"}}}},
    {"Materials", {{{"", ",", "a,a", "a:b", "a@b", "a/b"}}}},
    {"Gas/Ambient pressure", {{{"-1"}}}},
    {"Gas/Polytropic exponent", {{{"0", "-1"}}}},
    {"Gas/Cavity volume", {{{"0", "-1"}, {{"Gas/Ambient pressure", "0.1"}}}}},
    {"Gas/Rim radius", {{{"-1"}, {{"Gas/Ambient pressure", "0.1"}}}}},
    {"Laminate/Plies",
     {{{"",
        ",",
        "rubber",
        "rubber: 1",
        "rubber @ 1",
        ", rubber: 1 @ 0",
        "rubber: 1 @ 0,, rubber: 1 @ 0",
        "wood: 1 @ 0",
        "rubber: 0 @ 0",
        "rubber: -1 @ 0",
        "rubber: nan @ 0",
        "rubber: 1 @ inf",
        "rubber: 1e999 @ 0",
        "rubber: 1 @ 1e999",
        "rubber: @ 0",
        "rubber: 1 @",
        "rubber: 1x @ 0",
        "rubber: beta @ 0",
        "rubber: 1 @ (0",
        "rubber: 1 @ 0 from 1",
        "rubber: 1 @ 0 from 60 to -60",
        "rubber: 1 @ 0 from a to b",
        "rubber: 1 @ 0 from end to 0",
        "rubber: 1 @ 0 from 0 to 2*ends",
        "rubber: 1 @ 0 from 0 to 0.1*end",
        "rubber: 1 @ 0 from 0 end",
        "rubber: 1 @ +-",
        "rubber: 1 @ +-x",
        "rubber: r @ lift",
        "rubber: 1 @ lift()",
        "rubber: 1 @ lift(1, 2)",
        "rubber: 1 @ beta_c",
        "rubber: lift(38) - 38 @ 0",
        "1001 x (rubber: 1 @ 0)",
        "-1 x (rubber: 1 @ 0)",
        "1.5 x (rubber: 1 @ 0)",
        "x (rubber: 1 @ 0)",
        "2 x rubber: 1 @ 0",
        "2 x (rubber: 1 @ 0",
        "2 x ()",
        "2 x (rubber: 1 @ 0) from 0 to end",
        "100 x (100 x (rubber: 1 @ 0))",
        "1x(1x(1x(1x(1x(1x(1x(1x(1x(1x(1x(rubber:1@0)))))))))))",
        "rubber: 1/0 @ 0",
        "rubber: 1 @ 1/0"}}}},
    {"Laminate/Plies file", {{{"no_such_file.csv", "/", long_word}}}},
    {"Laminate/Tables",
     {{{"t",
        "t:",
        ": f",
        "t: no_such_file.csv",
        "pi: f",
        "2: f",
        "t: /",
        "_t: f"}}}},
    {"Laminate/Initial ply stresses",
     {{{"1", "1 2 3, 1 2 3", "1 2 x", "nan 0 0", "0 inf 0", "0 0 1e999"}}}},
    {"Laminate/Initial resultants",
     {{{"1",
        "H_11 = 1",
        "H_11 inner",
        "H_21 both = 1",
        "H_11 left = 1",
        "H_33 both = 1",
        "H_11 both = q",
        "H_11 both = 1/0",
        "H_11 both = 1e999",
        "H_22 outer ="}}}},
    {"Laminate/Transverse shear",
     {{{"",
        "shear",
        "factor",
        "0",
        "-0.5",
        "1.1",
        "nan",
        "1/0",
        "1e999",
        "alpha_1",
        "5/6 equilibrium"}}}},
    {"Laminate/Gradient factor",
     {{{"", "layers", "0", "0.99", "-1", "1001", "nan", "1/0", "1e999"}}}},
    {"Laminate/Layers",
     {{{"",
        "1/10000, 1",
        "two",
        "0",
        "-1",
        "0 per ply",
        "1.5 per ply",
        "101 per ply",
        "one per",
        "nan",
        "1/0",
        "1e999"}}}},
    {"Laminate/Reference surface",
     {{{"",
        "top",
        "ply",
        "ply 0",
        "ply 2",
        "ply 1.5",
        "ply x",
        "nan",
        "1e999",
        "0x1"}}}},
    {"Named points",
     {{{"A",
        "A:",
        "A: 1",
        "A: 1 2 3",
        "A: a b",
        "A: nan 0",
        "A: 0 inf",
        ": 0 0",
        "A: 0 0, A: 0 0",
        "A: 1 1"}}}},
    {"Supports/Edge supports",
     {{{"A", "A: soft", ": fixed", "A: symmetry", "A: v_4 both", "A: fixed"}}}},
    {"Supports/Springs", suspensions_of_supports},
    {"Supports/Dampers", suspensions_of_supports},
    {"Supports/Masses", suspensions_of_supports},
    {"Supports/Point supports",
     {{{"A",
        "A: fixed",
        "A: soft",
        ": fixed",
        "P: v_4 both",
        "P: v_1",
        "P: v_1 both = q",
        "P: symmetry"},
       {{"Named points", "P: 0 0"}}}}},
    {"Loads/Point forces",
     {{{"P", "P: 1 2", "P: 1 2 x", "Q: 1 2 3", "P: 1 2 nan", "P: 1 2 3 top"},
       {{"Named points", "P: 0 0"}}}}},
    {"Loads/Edge forces",
     {{{"alpha_1 min",
        "alpha_1 min: 1 2",
        "alpha_1 min: a b c",
        "alpha_2 min: 1 2 3",
        "rim: 1 2 3",
        "alpha_1 min: 1 2 1e999",
        "alpha_1 min: 1 2 3 ply",
        "alpha_1 min: 1 2 3 ply 0",
        "alpha_1 min: 1 2 3 ply 2",
        "alpha_1 min: 1 2 3 inner ply 1",
        "alpha_1 min: 1 2 3 length",
        "alpha_1 min: 1 2 3 true"}}}},
    {"Loads/Edge moments",
     {{{"alpha_1 min",
        "alpha_1 min: 1",
        "alpha_1 min: 1 alive",
        "alpha_1 min: x dead",
        "alpha_2 min: 1 dead",
        "rim: 1 dead",
        "alpha_1 min: inf dead"}}}},
    {"Loads/Inner traction",
     {{{"1",
        "1; 2",
        "1; 2; 3; 4",
        "1; 2; q",
        "1; 2; 1/0",
        "1; 2; 1e999",
        "1; 2;"}}}},
    {"Loads/Outer traction",
     {{{"1",
        "1; 2",
        "1; 2; 3; 4",
        "1; 2; q",
        "1; 2; 1/0",
        "1; 2; 1e999",
        "1; 2;"}}}},
    {"Loads/Pressure distribution",
     {{{"", "q", "1,", "1; 2", "x = 1", "1/0", "1e999", "(1"}}}},
    {"Contact/Direction", {{{"0, 0, 0"}}}},
    {"Contact/Regularization", {{{"0", "-1"}}}},
    {"Contact/Drum/Radius",
     {{{"none", "0"}, {{"Contact/Foundation", "drum"}}}}},
    {"Contact/Sphere/Radius",
     {{{"none", "0"}, {{"Contact/Foundation", "sphere"}}}}},
    {"Contact/Friction",
     {{{"",
        "-0.1",
        "a",
        "p p",
        "0.5, 1",
        "p = 1",
        "1/0",
        "sqrt(-p)",
        "nan",
        long_word}}}},
    {"Contact/Tangential regularization", {{{"0", "-1"}}}},
    {"Bodies", {{{",", "bar, bar", "a:b", "a@b", "a/b"}}}},
    {"Body bar/Radius", {{{"none", "0"}, {{"Body bar/Shape", "sphere"}}}}},
    {"Body bar/Tube radius",
     {{{"none", "0", "-1", "11"},
       {{"Body bar/Shape", "torus"}, {"Body bar/Radius", "10"}}}}},
    {"Body bar/Half angle",
     {{{"none", "0", "-1", "90"}, {{"Body bar/Shape", "cone"}}}}},
    {"Body bar/Edge radius", {{{"-1"}, {{"Body bar/Shape", "step"}}}}},
    {"Body bar/Direction", {{{"0, 0, 0"}}}},
    {"Body bar/Axis",
     {{{"0, 0, 0"}}, {{"1, 0, 0"}, {{"Body bar/Shape", "step"}}}}},
    {"Body bar/Profile",
     {{{"0 0, 1 1"}},
      {{"",
        ",",
        "0 0",
        "0 0, 1",
        "0 0, 1 x",
        "0 0, 1 nan",
        "0 0, 1e999 0",
        "0 0, 1 0 1 1",
        "0 0, 0 0, 1 0",
        "0 0, 1 0 -1, 1 1",
        "0 0, 1 0 5, 1 1",
        "0 0, 1 0, 0 0"},
       {{"Body bar/Shape", "extruded"}}}}},
    {"Body bar/Profile file",
     {{{"no_such_file.csv", "/", "\"a", long_word},
       {{"Body bar/Shape", "extruded"}}},
      {{"every_entry.prm"},
       {{"Body bar/Shape", "extruded"}, {"Body bar/Profile", "0 0, 1 1"}}}}},
    {"Body bar/Height file",
     {{{"a.csv"}},
      {{"", "no_such_file.csv", "/", "\"a", long_word},
       {{"Body bar/Shape", "height field"}}}}},
    {"Body bar/Formula",
     {{{"x"}},
      {{"",
        "a",
        "x, y",
        "x = 1",
        "1/0",
        "sqrt(x)",
        "nan",
        "1",
        "x^2 + 1",
        "x^3",
        long_word},
       {{"Body bar/Shape", "formula"}, {"Body bar/Size", "1"}}}}},
    {"Body bar/Size",
     {{{"none", "0", "-1", "10000"},
       {{"Body bar/Shape", "formula"},
        {"Body bar/Formula", "z - 2*sin(x/30)"}}}}},
    {"Body bar/Friction",
     {{{"", "-0.1", "a", "0.5, 1", "1/0", "sqrt(-p)", "nan", long_word}}}},
    {"Body bar/Moves with", {{{"ground"}}}},
    {"Body bar/Motions",
     {{{"up",
        "up:",
        ": 1 0 0",
        "up: 1 0",
        "up: 1 0 x",
        "up: 1 0 nan",
        "up: 1e999 0 0",
        "up: 1 0 0 turn 1 about 0 1",
        "up: 1 0 0 turn 1 about 0 0 0",
        "up: 1 0 0 5",
        "up: 1 0 0 turn",
        "up: 1 0 0 turn x",
        "up: 1 0 0, up: 0 1 0"}}}},
    {"Body bar/Springs", suspensions_of_bodies},
    {"Body bar/Dampers", suspensions_of_bodies},
    {"Body bar/Masses", suspensions_of_bodies},
    {"Loads/End plates",
     {{{",", "alpha_1", "top", "alpha_2 min", "alpha_1 min, alpha_1 min"}}}},
    {"Stage 1/Forces on bodies",
     {{{"bar up",
        "bar up:",
        "bar up: x",
        "bar up: nan",
        "bar up: 1e999",
        ": 1",
        "bar down: 1",
        "up: 1",
        "bar up: 1, bar up: 2"},
       {{"Body bar/Motions", "up: 1 0 0"}, {"Stage 1/Bodies", "bar"}}}}},
    {"Stage 1/Bodies", {{{"rim", "bar, bar", "bar, rim", ","}}}},
    {"Newton/Residual tolerance", {{{"0", "-1"}}}},
    {"Newton/Update tolerance", {{{"-1"}}}},
    {"Stage 1/Name", {{{"", "a,b", "a\"b"}}}},
    {"Stage 1/Start from",
     {{{"", "1", "0", "-1", "2", "1.5", "first", "nan", "1e999"}}}},
    {"Stage 1/Travel",
     {{{"1"}},
      {{"1"},
       {{"Stage 1/Contact", "true"},
        {"Stage 1/Control", "foundation force"},
        {"Stage 1/Force", "1"}}}}},
    {"Stage 1/Load factors",
     {{{"1",
        "area force",
        "area force:",
        "area force: x",
        "area force: nan",
        "area force: 1e999",
        ": 1",
        "area force: 1",
        "pressure: 1"}},
      {{"area force: 1, area force: 2",
        "area force 1: 1",
        "edge forces: 1",
        "area force: 1, edge forces alpha_1 min: 1"},
       {{"Loads/Area force", "0, 0, 1"}}}}},
    {"Stage 1/Slide",
     {{{"",
        "1",
        "0, 1",
        "0, 1, 0, 0",
        "a, b, c",
        "0, nan, 0",
        "0, 1e999, 0",
        "0, 1, 0"}},
      {{"1, 0, 0", "0.001, 1, 0"}, {{"Stage 1/Contact", "true"}}}}},
    {"Stage 1/Turn", {{{"1"}}}},
    {"Stage 1/Wheel turn", {{{"1"}}}},
    {"Stage 1/Angular velocity",
     {{{"1"}, {{"Mesh/Closed in alpha_2", "false"}}}}},
    {"Stage 1/Ground velocity", {{{"1"}}}},
    {"Stage 1/Slip ratio",
     {{{"0.1"}}, {{"0.1", "-1"}, {{"Stage 1/Contact", "true"}}}}},
    {"Stage 1/Axle moment", {{{"1"}}}},
    {"Contact/Critical velocity", {{{"-1"}}}},
    {"Stage 1/Friction",
     {{{"0.5"}},
      {{"-0.1", "a", "1/0", long_word}, {{"Stage 1/Contact", "true"}}}}},
    {"Stage 1/Glued", {{{"true"}}, {{"true"}, {{"Stage 1/Contact", "true"}}}}},
    {"Stage 1/Force",
     {{{"1"}},
      {{"0", "-1"},
       {{"Stage 1/Contact", "true"},
        {"Stage 1/Control", "foundation force"}}}}},
    {"Stage 1/Control", {{{"foundation force", "axle moment"}}}},
    {"Tire test/Start from",
     {{{"", "first", "0", "-1", "1.5", "1001", "nan", "1e999"}}}},
    {"Tire test/Loads", {{wrong_lists}}},
    {"Tire test/Pressures", {{wrong_lists}}},
    {"Tire test/Inclination angles", {{wrong_lists}}},
    {"Tire test/Slip angles", {{wrong_lists}}},
    {"Tire test/Slip ratios", {{wrong_lists}}},
    {"Sensitivities/Entries",
     {{{"nothing", "Mesh/Intervals alpha_3"},
       {{"Sensitivities/Outputs", "force"}}}}},
    {"Sensitivities/Outputs",
     {{{"nothing", "top u_x"},
       {{"Sensitivities/Entries", "Stage 1/Pressure"}}}}},
    {"Sensitivities/Stages", {{{"9", "0", "x"}}}},
    {"Sensitivities/Relative step",
     {{{"0", "-1"}},
      {{"0.5"},
       {{"Sensitivities/Entries", "Stage 1/Pressure"},
        {"Sensitivities/Outputs", "strain_energy"}}}}},
    {"Stage 1/Control point",
     {{{"", "Q"},
       {{"Stage 1/Control", "displacement"}, {"Stage 1/Control value", "1"}}}}},
    {"Stage 1/Strain theory",
     {{{"linear"}, {{"Stage 1/Control", "arc length"}}}}},
    {"Material rubber/E", {{{"0", "-1"}}}},
    {"Material rubber/E_cord", {{{"0", "-1", "59"}, cords_in_rubber}}},
    {"Material rubber/nu_cord", {{{"-0.1", "0.5"}, cords_in_rubber}}},
    {"Material rubber/E_rubber", {{{"0", "-1"}, cords_in_rubber}}},
    {"Material rubber/nu_rubber", {{{"0.3", "0.5"}, cords_in_rubber}}},
    {"Material rubber/Cord diameter", {{{"0", "-1"}, cords_in_rubber}}},
    {"Material rubber/Cord pitch", {{{"0", "-1", "0.6"}, cords_in_rubber}}},
    {"Material rubber/nu", {{{"0.5", "-1", "1"}}}},
    {"Material rubber/mu", {{{"1"}}, {{"0", "-1"}, rubber("neo-Hooke", {})}}},
    {"Material rubber/K",
     {{{"1"}},
      {{"0.5", "-1"}, rubber("neo-Hooke", {{"Material rubber/mu", "1"}})}}},
    {"Material rubber/c10", {{{"1"}}, {{"0", "-1"}, rubber("Yeoh", {})}}},
    {"Material rubber/c20",
     {{{"1"}, rubber("Mooney-Rivlin", {{"Material rubber/c10", "1"}})}}},
    {"Material rubber/c30", {{{"1"}}}},
    {"Material rubber/c01",
     {{{"1"}},
      {{"-1", "-2"}, rubber("Mooney-Rivlin", {{"Material rubber/c10", "1"}})}}},
    {"Material rubber/mu_i",
     {{{"1"}},
      {{"", "-1", "0"}, rubber("Ogden", {{"Material rubber/alpha_i", "2"}})}}},
    {"Material rubber/alpha_i",
     {{{"1"}},
      {{"", "1, 2", "0"}, rubber("Ogden", {{"Material rubber/mu_i", "2"}})}}},
    {"Material rubber/Relaxation times",
     {{{"0", "-1"}, {{"Material rubber/Relaxation moduli", "0.5"}}}}},
    {"Material rubber/Relaxation moduli",
     {{{"0.5"}, {}},
      {{"1", "0", "-1", "0.5, 0.1"},
       {{"Material rubber/Relaxation times", "1"}}}}},
    {"Material rubber/Temperature shift", {{{"WLF", "Arrhenius"}}}},
    {"Material rubber/WLF C1",
     {{{"1"}},
      {{"0", "-1"},
       {{"Material rubber/Relaxation times", "1"},
        {"Material rubber/Relaxation moduli", "0.5"},
        {"Material rubber/Temperature shift", "WLF"}}}}},
    {"Material rubber/WLF C2",
     {{{"1"}},
      {{"0", "-1"},
       {{"Material rubber/Relaxation times", "1"},
        {"Material rubber/Relaxation moduli", "0.5"},
        {"Material rubber/Temperature shift", "WLF"}}}}},
    {"Material rubber/Arrhenius constant",
     {{{"1"}},
      {{"0", "-1"},
       {{"Material rubber/Relaxation times", "1"},
        {"Material rubber/Relaxation moduli", "0.5"},
        {"Material rubber/Temperature shift", "Arrhenius"},
        {"Material rubber/Reference temperature", "293"}}}}},
    {"Material rubber/Reference temperature",
     {{{"0", "-1"},
       {{"Material rubber/Relaxation times", "1"},
        {"Material rubber/Relaxation moduli", "0.5"},
        {"Material rubber/Temperature shift", "Arrhenius"},
        {"Material rubber/Arrhenius constant", "1000"}}}}},
    {"Material rubber/Thermal conductivity", {{{"-1"}}}},
    {"Heat/Temperatures", {{{"computed", "coupled"}}}},
    {"Heat/Inside film", {{{"-1"}}}},
    {"Heat/Air film", {{{"-1"}}}},
    {"Heat/Ground film", {{{"-1"}}}},
    {"Stage 1/Duration", {{{"-1"}}}},
    {"Stage 1/Time step", {{{"1", "0", "-1"}}, {{"0", "-1"}, in_motion}}},
    {"Stage 1/Time error", {{{"-1", "2"}, in_motion}}},
    {"Stage 1/Initial velocity",
     {{{"1; 0; 0"}}, {{"1", "1; 0", "1; 0; 0; 0", "1; 0; q"}, in_motion}}},
    {"Stage 1/Initial velocities of bodies",
     {{{"bar up: 1"}},
      {{"bar up", "bar up: x", "bar up: nan", "bar up: 1"}, in_motion}}},
    {"Stage 1/History tables",
     {{{"road: no_such_file.csv", "t: file.csv", "road", "1road: file.csv"},
       in_motion}}},
    {"Stage 1/Load history",
     {{{"travel: t"}},
      {{"load factor",
        "load factor: q",
        "load factor: t; load factor: 2*t",
        "flow: t",
        "load factor: 1/0"},
       in_motion}}},
    {"Stage 1/Mass damping",
     {{{"1", "-1"}}, {{"-1"}, in_motion}, {{"-1"}, shaken}}},
    {"Stage 1/Stiffness damping",
     {{{"1", "-1"}}, {{"-1"}, in_motion}, {{"-1"}, shaken}}},
    {"Stage 1/Frequency response",
     {{{"-1", "q"}}, {{"-1", "1:2", "1:2:0", "nan", "1e999"}, shaken}}},
    {"Stage 1/Excitations",
     {{{"load factor"}},
      {{"",
        "ground",
        "ground x",
        "supports w",
        "nothing x",
        "load factor, load factor",
        "load factor,"},
       shaken}}},
    {"Stage 1/Loss factor", {{{"0.1", "-1"}}, {{"-1", "3"}, shaken}}},
    {"Gas/Sound speed", {{{"0", "-1"}}}},
    {"Gas/Adiabatic exponent", {{{"0", "-1"}}}},
    {"Stage 1/Moment of inertia", {{{"1", "-1"}}, {{"-1"}, in_motion}}},
    {"Stage 1/Numerical damping", {{{"1", "-1"}}, {{"-1", "3"}, in_motion}}},
    {"Stage 1/Contact damping", {{{"1", "-1"}}, {{"-1", "2"}, in_motion}}},
    {"Material rubber/Matrix", {{{"neo-Hooke"}}}},
    {"Material rubber/Cord curve", {{{"no_such_file.csv", "/", long_word}}}},
    {"Material rubber/E_T", {{{"1"}, cords_in_neo_Hooke}}},
    {"Material rubber/Compression onset",
     {{{"-1", "1", "E_T", "", "nan"},
       [] {
         Settings slack                           = cords_in_neo_Hooke;
         slack["Material rubber/E_L compression"] = "E_L/10";
         return slack;
       }()}}},
    {"Material rubber/E_L compression",
     {{{"", "1", "E_L/10", "E_L compression"}},
      {{"", "0", "-1", "2.5", "2*E_L", "E_T", "1/0", "nan", "1e999", "1 1"},
       {{"Material rubber/Type", "transversely isotropic"},
        {"Material rubber/E_L", "2"},
        {"Material rubber/E_T", "1"},
        {"Material rubber/G_LT", "1"},
        {"Material rubber/G_TT", "1"}}}}},
  };

  /** The analysis that each wrong value is put into. */
  const Settings sound{
    {"Mesh/Intervals alpha_1", "-120:120:4"},
    {"Mesh/Intervals alpha_2", "-180:180:4"},
    {"Materials", "rubber"},
    {"Bodies", "bar"},
    {"Material rubber/Type", "isotropic"},
    {"Material rubber/E", "5"},
    {"Material rubber/nu", "0.4"},
    {"Laminate/Plies", "rubber: 1 @ 0"},
    {"Supports/alpha_1 min", "fixed"},
    {"Supports/alpha_1 max", "fixed"},
    {"Stage 1/Pressure", "0.1"},
  };


  struct Entry
  {
    std::string name;
    /** As ParameterHandler describes it. */
    std::string             pattern;
    std::string             documentation;
    Biface::EntryAttributes attributes;
  };


  void
  collect(const boost::property_tree::ptree &tree,
          const std::string                 &path,
          std::vector<Entry>                &entries)
  {
    for (const auto &child : tree)
      {
        const std::string name = path + child.first;
        if (const auto pattern =
              child.second.get_optional<std::string>("pattern_description"))
          entries.push_back({name,
                             *pattern,
                             child.second.get<std::string>("documentation"),
                             {}});
        else
          collect(child.second, name + "/", entries);
      }
  }


  std::vector<Entry>
  all_entries()
  {
    // with the sections of the sound analysis
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::ofstream("names.prm")
        << "set Materials = rubber\nset Bodies = bar\n";
    Biface::Parameters parameters;
    ParameterHandler   prm;
    Biface::parse_parameters("names.prm", {}, MPI_COMM_WORLD, parameters, prm);
    std::stringstream text;
    prm.print_parameters(text, ParameterHandler::JSON);
    boost::property_tree::ptree tree;
    boost::property_tree::read_json(text, tree);
    std::vector<Entry> entries;
    collect(tree, "", entries);
    for (Entry &entry : entries)
      entry.attributes = parameters.attributes.at(entry.name);
    return entries;
  }


  /** Each number has a unit, or none, which its documentation takes from the
   * declaration. */
  void
  check_units(const std::vector<Entry> &entries)
  {
    for (const Entry &entry : entries)
      {
        const Biface::Unit &unit = entry.attributes.get_unit();
        for (const char *numbers :
             {"[Double", "[Number or ", "[List of <[Double"})
          if (entry.pattern.rfind(numbers, 0) == 0 && !unit.is_said())
            check_true("the unit of " + entry.name + " is declared", false);
        for (const char *sentence : {"Unit: ", "Units: ", "No unit."})
          {
            const auto at = entry.documentation.find(sentence);
            if (at != std::string::npos &&
                entry.documentation.substr(at) != unit.sentence())
              check_true("the unit in the text of " + entry.name +
                           " is the declared one",
                         false);
          }
      }
  }


  /** What is declared without a word on it may not change at a restart, and
   * has the attributes of its section. */
  void
  check_defaults()
  {
    using namespace Biface;
    dealii::ParameterHandler handler;
    EntryDeclarations        prm(handler);
    double                   value = 0;
    prm.add_parameter("Alone", value, "A number.");
    prm.enter_subsection("Solver", EntryKind::solution);
    prm.enter_subsection("Inner");
    prm.add_parameter("Count", value, "A number.");
    prm.add_parameter(
      "Kept", value, "A number.", Unit("force") | RestartChange::never);
    prm.leave_subsection();
    prm.leave_subsection();
    const EntryAttributes alone = prm.get_attributes().at("Alone");
    check_true("by default an entry describes the problem",
               alone.describes_the_problem());
    check_true("by default an entry may not change at a restart",
               alone.get_restart_change() == RestartChange::never);
    const EntryAttributes count = prm.get_attributes().at("Solver/Inner/Count");
    check_true("an entry has the attributes of the sections around it",
               !count.describes_the_problem() &&
                 count.get_restart_change() == RestartChange::always);
    const EntryAttributes kept = prm.get_attributes().at("Solver/Inner/Kept");
    check_true("its own attributes take precedence",
               kept.get_kind() == EntryKind::solution &&
                 kept.get_restart_change() == RestartChange::never &&
                 kept.get_unit().get_name() == "force");
  }


  /** Values of the wrong kind, or beyond the bounds that are declared. */
  std::vector<std::string>
  wrong_values(const std::string &pattern)
  {
    if (pattern.rfind("[Double", 0) == 0 || pattern.rfind("[Number", 0) == 0)
      {
        std::vector<std::string> values{"",
                                        "word",
                                        "nan",
                                        "1x",
                                        "1 2",
                                        "1,5",
                                        "inf",
                                        "-inf",
                                        "1e999",
                                        "-1e999",
                                        "1e200",
                                        "0x10",
                                        "1e",
                                        "--1",
                                        "true",
                                        long_word};
        if (pattern.find("...MAX_DOUBLE") != std::string::npos &&
            pattern.find("-MAX_DOUBLE") == std::string::npos)
          values.emplace_back("-1");
        return values;
      }
    if (pattern.rfind("[Integer", 0) == 0)
      return {"",
              "word",
              "1.5",
              "1x",
              "1 2",
              "1e3",
              "nan",
              "-1",
              "4000000000",
              "99999999999999999999",
              "0x10",
              "true",
              long_word};
    if (pattern.rfind("[List of <[Double", 0) == 0)
      return {"",
              "1",
              "1, 2, 3, 4",
              "1, x, 3",
              "a, b",
              "nan, nan, nan",
              "1, 2, 1e999",
              "1, 1e200, 0",
              "inf, 0",
              long_word};
    if (pattern.rfind("[Bool", 0) == 0)
      return {"", "maybe", "1", "True", "true false", "nan", long_word};
    if (pattern.rfind("[MultipleSelection", 0) == 0)
      return {"word", "1", "nan", long_word};
    if (pattern.rfind("[Selection", 0) == 0)
      return {"", "word", "1", "nan", long_word};
    return {};
  }


  std::string
  as_file(const Settings &settings)
  {
    std::string text;
    for (const auto &setting : settings)
      {
        std::string name = setting.first, end;
        for (auto slash = name.find('/'); slash != std::string::npos;
             slash      = name.find('/'))
          {
                 text += "subsection " + name.substr(0, slash) + "\n";
                 end += "end\n";
                 name.erase(0, slash + 1);
          }
        text += "  set " + name + " = " + setting.second + "\n" + end;
      }
    return text;
  }


  /** What is wrong with the answer; empty if nothing is. */
  std::string
  fault(const int          code,
        const std::string &said,
        const std::string &entry,
        const std::string &value)
  {
    const auto holds = [&](const std::string &what) {
      return said.find(what) != std::string::npos;
    };
    if (code != Biface::wrong_input)
      return "exit code " + std::to_string(code);
    if (std::count(said.begin(), said.end(), '\n') != 1 ||
        said.rfind("biface: ", 0) != 0 || said.size() < 3 ||
        said[said.size() - 2] != '.')
      return "not one sentence";
    if (said.size() > 1000)
      return "not short";
    if (!holds("every_entry.prm"))
      return "does not name the file";
    const std::string section = entry.substr(0, entry.find_last_of('/'));
    // a file that an entry names is named in its place
    const bool names_file    = holds("the file '");
    const bool names_section = holds("the section '" + section + "'");
    if (!holds("'" + entry + "'") && !names_section && !names_file)
      return "does not name the entry";
    // the value, or the part of it that is wrong
    const auto        is   = said.find(" is '");
    const std::string part = said.substr(is + 5, said.find("', but ") - is - 5);
    const bool        names_part =
      is != std::string::npos &&
      (part.empty() ? value.empty() : value.find(part) != std::string::npos);
    if (!names_part && !names_file && !names_section &&
        !holds(value.substr(0, 100)))
      return "does not name the value";
    if (!holds(", but "))
      return "does not say what is allowed";
    for (const char *word : {"[", "MAX", "xception", "pattern", "Pattern"})
      if (holds(word))
        return "not plain";
    return {};
  }


  unsigned int n_runs   = 0;
  unsigned int n_faults = 0;

  void
  try_settings(Settings           settings,
               const std::string &entry,
               const std::string &value,
               const Settings    &others)
  {
    for (const auto &other : others)
      settings[other.first] = other.second;
    settings[entry]    = value;
    const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (is_root)
      std::ofstream("every_entry.prm") << as_file(settings);
    MPI_Barrier(MPI_COMM_WORLD);

    std::ostringstream out, err;
    int                code = -1;
    try
      {
        code = Biface::run_program(
          {"--check", "every_entry.prm"}, MPI_COMM_WORLD, out, err);
      }
    catch (const std::exception &exception)
      {
        err << exception.what();
      }
    ++n_runs;
    if (!is_root)
      return;
    const std::string what = fault(code, err.str(), entry, value);
    if (what.empty())
      return;
    ++n_faults;
    std::cout << "FAILED, " << entry << " = '" << value.substr(0, 100)
              << "': " << what << ": " << err.str().substr(0, 500) << std::endl;
  }
} // namespace


int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const std::vector<Entry> entries = all_entries();
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      check_units(entries);
      check_defaults();
    }
  std::set<std::string> names;
  // one parser reads all entries of a kind: of the values that are wrong for
  // it, each entry gets the first three and, by turns, a third of the others
  unsigned int turn = 0;
  for (const Entry &entry : entries)
    {
      names.insert(entry.name);
      const std::vector<std::string> values = wrong_values(entry.pattern);
      for (unsigned int i = 0; i < values.size(); ++i)
        if (i < 3 || i % 3 == turn % 3 || values[i] == "-1")
          try_settings(sound, entry.name, values[i], {});
      ++turn;

      const auto wrong = by_name.find(entry.name);
      if (wrong != by_name.end())
        for (const Wrong &w : wrong->second)
          for (const std::string &value : w.values)
            try_settings(sound, entry.name, value, w.others);
      else if (entry.name.rfind("Supports/alpha_", 0) == 0)
        for (const char *value : {"",
                                  "soft",
                                  "v_4 both",
                                  "v_1",
                                  "v_1 left",
                                  "v_1 both = q",
                                  "v_1 both =",
                                  "v_1 both = 1/0",
                                  "v_1 both = nan",
                                  "v_1 both = 1e999",
                                  "fixed; hinged"})
          try_settings(sound, entry.name, value, {});
      else if (entry.pattern == "[Anything]" && any_text.count(entry.name) == 0)
        check_true("what is wrong for the entry " + entry.name + " is known",
                   false);
    }
  for (const auto &wrong : by_name)
    if (names.count(wrong.first) == 0)
      check_true("there is an entry " + wrong.first, false);

  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    {
      check_true("every entry has been tried", n_runs > 3 * entries.size());
      check_true("all wrong values are refused with a sentence", n_faults == 0);
    }
  return 0;
}
