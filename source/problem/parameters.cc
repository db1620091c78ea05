// SPDX-License-Identifier: LGPL-2.1-or-later

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>

#include <biface/base/errors.h>
#include <biface/input/entry_declarations.h>
#include <biface/input/parameter_tools.h>
#include <biface/laminate/relaxation.h>
#include <biface/model/mesh/plies_on_surface.h>
#include <biface/problem/parameters.h>
#include <biface/restart/checkpoint.h>
#include <biface/stepping/stage_sequence.h>
#include <biface/surface/imperfection.h>
#include <biface/surface/quadrilateral_mesh.h>

namespace Biface
{
  using namespace dealii;

  namespace
  {
    /** Names in the form of parameter files. */
    std::string
    listed(const std::vector<std::string> &names)
    {
      std::string list;
      for (const std::string &name : names)
        list += (list.empty() ? "" : ", ") + name;
      return list;
    }
  } // namespace


  void
  Parameters::add_parameters(ParameterHandler               &handler,
                             const std::vector<std::string> &material_names,
                             const std::vector<std::string> &body_names,
                             const unsigned int              n_stages)
  {
    EntryDeclarations prm(handler);
    const auto        add_section = [&prm](const std::string     &name,
                                    auto                  &part,
                                    const EntryAttributes &attributes = {}) {
      prm.enter_subsection(name, attributes);
      part.add_parameters(prm);
      prm.leave_subsection();
    };

    // the names of materials and bodies, and the number of stages, must have
    // been read before: each has a section
    units.add_parameters(prm);
    add_section("Surface", surface, EntryKind::shape);
    add_section("Mesh", mesh, EntryKind::shape);
    prm.declare_entry("Materials",
                      listed(material_names),
                      Patterns::Anything(),
                      "Names of the materials, separated by commas. Each has "
                      "a section 'Material NAME'.");
    materials.resize(material_names.size());
    for (unsigned int i = 0; i < materials.size(); ++i)
      {
        materials[i].name = material_names[i];
        add_section(
          "Material " + material_names[i], materials[i], EntryKind::plies);
      }
    add_section("Laminate", laminate, EntryKind::plies);
    // the element of the paper remains a choice, with which its results can be
    // repeated
    add_choice(
      prm,
      "Formulation",
      formulation,
      {"standard", "vertices", "paper"},
      "The element. 'standard': the faces of a cell and their displacement "
      "vectors are bilinear, so that no rigid motion strains it; cells are flat "
      "or warped quadrilaterals of any shape. 'vertices': the same, with "
      "strains that are sampled at the vertices alone, for comparisons; where "
      "the shell is compressed, it may buckle from node to node. 'paper': the "
      "element of Grigolyuk, Kulikov and Plotnikova (2004), with strains of the "
      "vertices and components of the displacements, in the frames of the "
      "surface, that are bilinear: it knows the curvature inside a cell, but "
      "where the frames turn, a rigid motion strains it. For one of "
      "'Laminate/Layers' and not for meshes of files.");
    points.add_parameters(prm);
    add_section("Supports", supports);
    prm.enter_subsection("Loads", EntryKind::loads);
    pressure.add_parameters(prm);
    loads.add_parameters(prm);
    prm.leave_subsection();
    add_section("Gas", gas, EntryKind::loads);
    add_section("Contact", contact, EntryKind::loads);
    add_section("Heat", heat);
    prm.declare_entry("Bodies",
                      listed(body_names),
                      Patterns::Anything(),
                      "Names of rigid bodies beside the ground of the "
                      "section 'Contact', separated by commas. Each has a "
                      "section 'Body NAME', and is there in stages that name "
                      "it.");
    bodies.resize(body_names.size());
    for (unsigned int i = 0; i < bodies.size(); ++i)
      {
        bodies[i].name = body_names[i];
        add_section("Body " + body_names[i], bodies[i]);
      }
    add_stages(prm, n_stages);
    add_section("Tire test", tire_test, RestartChange::before_tire_test);
    add_section("Linear solver", linear_solver, EntryKind::solution);
    add_section("Newton", newton, EntryKind::solution);
    add_section("Step control", load_stepping, EntryKind::solution);
    add_section("Output", output, EntryKind::output);
    add_section("Checkpoint", checkpoint, EntryKind::output);
    // what a run carries along for derivatives is part of its state
    add_section(
      "Sensitivities", sensitivities, EntryKind::output | RestartChange::never);
    attributes = prm.get_attributes();
  }


  void
  Parameters::add_stages(EntryDeclarations &prm, const unsigned int n_stages)
  {
    // check_continuation() compares the number with the progress of the run
    prm.declare_entry("Number of stages",
                      std::to_string(n_stages),
                      Patterns::Integer(1, 1000),
                      "Number of stages. Each has a section 'Stage 1', "
                      "'Stage 2', ... and starts from the end of the "
                      "previous one, or of that in 'Start from'. A number "
                      "smaller than that of the sections ends the run "
                      "earlier: the other sections are ignored, which a note "
                      "says.",
                      RestartChange::always);
    stages.resize(n_stages);
    for (unsigned int i = 0; i < n_stages; ++i)
      {
        prm.enter_subsection("Stage " + std::to_string(i + 1),
                             EntryKind::loads | RestartChange::before_stage |
                               OfStage{i + 1});
        stages[i].add_parameters(prm, i + 1);
        prm.leave_subsection();
      }
  }


  void
  Parameters::add_tire_test()
  {
    tire_test.check(stages);
    first_rig_point = stages.size();
    if (!tire_test.is_requested())
      return;
    const auto refuse = [](const std::string &why) {
      throw InputError("the section 'Tire test' needs " + why + '.');
    };
    if (!mesh.closed ||
        surface.type != ReferenceSurface::Parameters::Type::revolution)
      refuse("a wheel: 'Surface/Type = surface of revolution' and 'Mesh/Closed "
             "in alpha_2 = true'");
    if (!sensitivities.entries.empty())
      refuse("an empty entry 'Sensitivities/Entries'");
    const unsigned int start = tire_test.number_of_start(stages);
    if (rolling_stages()[start - 1])
      refuse(
        "a stage 'Start from' in which the wheel does not roll, not stage " +
        std::to_string(start));
    first_rig_point = tire_test.append_to(stages);
  }


  void
  Parameters::check() const
  {
    for (const PointSupport &support : supports.points)
      find_point(points.list, "Supports/Point supports", support.point);
    for (const PointForce &force : loads.point_forces)
      find_point(points.list, "Loads/Point forces", force.point);
    if (surface.type == ReferenceSurface::Parameters::Type::mesh)
      check_mesh_from_file();
    else
      check_edges();

    supports.check();
    contact.check();
    heat.check();
    newton.check();
    sensitivities.check(stages.size());
    check_stages(stages);
    check_bodies();
    check_gas();
    check_damping();
    check_inertia();
    check_response();
    check_friction();
    for (unsigned int i = 0; i < stages.size(); ++i)
      stages[i].check_slide("Stage " + std::to_string(i + 1),
                            contact.body.line.direction);
    for (unsigned int i = 0; i < stages.size(); ++i)
      {
        const std::string entry =
          "Stage " + std::to_string(i + 1) + "/Control point";
        if (!stages[i].control_point.empty())
          find_point(points.list, entry, stages[i].control_point);
      }
    const bool revolution =
      surface.type == ReferenceSurface::Parameters::Type::revolution;
    PlyVariables variables;
    variables.radius = revolution;
    variables.crown_cord_angle =
      revolution &&
      surface.meridian ==
        ReferenceSurface::Parameters::MeridianType::cord_equilibrium;
    variables.position =
      (surface.type == ReferenceSurface::Parameters::Type::mesh);
    laminate.check(materials, variables);
    surface.imperfection.check(revolution);
    check_formulation();
    // what parts demand of each other, once each of them is valid
    check_densities();
    check_laws();
    check_imperfection();
    check_heat();
    check_rolling();
  }


  void
  Parameters::check_formulation() const
  {
    // the thickness stress of several layers would converge to a wrong limit
    // with the law of the paper, and their shear needs another thickness strain
    // than that of its element
    if (formulation == Formulation::paper && laminate.n_layers() > 1)
      throw InputError("Formulation",
                       "paper",
                       "it must be 'standard' with several 'Laminate/Layers'");
    if (formulation != Formulation::paper &&
        laminate.law == ThicknessLaw::asymmetric)
      throw InputError("Laminate/Thickness law",
                       "asymmetric",
                       "it must be 'symmetric' without 'Formulation = paper'");
  }


  void
  Parameters::check_imperfection() const
  {
    if (surface.imperfection.is_zero())
      return;
    const auto refuse = [&](const std::string &why) {
      throw InputError(
        "Surface/Imperfection/Formula", surface.imperfection.formula, why);
    };
    const std::vector<bool> rolling = rolling_stages();
    if (std::find(rolling.begin(), rolling.end(), true) != rolling.end())
      refuse("it must be 0 where the shell rolls: what turns must be the same "
             "all around");
    for (const Stage &stage : stages)
      if (stage.from_prestress)
        refuse("it must be 0 with 'Start from prestress'");
    if (!laminate.initial_stresses.empty() ||
        !laminate.initial_resultants.empty())
      refuse("it must be 0 with initial stresses or resultants");
  }


  void
  Parameters::check_bodies() const
  {
    // other lines of forces.csv
    std::set<std::string> lines{"foundation",
                                "loads",
                                "prestress",
                                "interpolation",
                                "inertia",
                                // a column of history.csv
                                "recovered",
                                "alpha_1 min",
                                "alpha_1 max",
                                "alpha_2 min",
                                "alpha_2 max"};
    for (const BodyParameters &body : bodies)
      {
        // names of files have no blanks
        // 'supports' is the first word of names in 'Forces on bodies'
        if (lines.count(body.name) > 0 || body.name.rfind("point ", 0) == 0 ||
            (body.name + " ").rfind("supports ", 0) == 0 ||
            !lines.insert(with_underscores(body.name)).second)
          throw InputError("Bodies",
                           body.name,
                           "the names of bodies must differ, also with '_' in "
                           "place of blanks, must not begin with 'supports', "
                           "and must not be those of other lines of "
                           "forces.csv or columns of history.csv");
      }
    for (const BodyParameters &body : bodies)
      body.check();
    for (unsigned int i = 0; i < stages.size(); ++i)
      for (const std::string &name : stages[i].bodies)
        {
          const std::string entry =
            "Stage " + std::to_string(i + 1) + "/Bodies";
          const auto body =
            std::find_if(bodies.begin(), bodies.end(), [&](const auto &body) {
              return body.name == name;
            });
          if (body == bodies.end())
            throw InputError(entry, name, "it must be listed in 'Bodies'");
          if (std::count(
                stages[i].bodies.begin(), stages[i].bodies.end(), name) > 1)
            throw InputError(entry, name, "it is named twice");
          if (body->on_ground && !stages[i].contact)
            throw InputError(entry,
                             name,
                             "it moves with the ground, which needs "
                             "'Contact = true'");
        }
  }


  void
  Parameters::check_densities() const
  {
    const auto stage =
      std::find_if(stages.begin(), stages.end(), [](const Stage &stage) {
        return stage.n_modes > 0 || stage.inertia || stage.vibrates();
      });
    // frequencies without a part of the mass would mean nothing
    if (stage == stages.end())
      return;
    for (const PlyParameters &ply : laminate.plies)
      for (const MaterialParameters &material : materials)
        if (material.name == ply.material && material.density == 0)
          throw InputError("Material " + material.name + "/Density",
                           "0",
                           std::string("it must be positive for the ") +
                             (stage->inertia      ? "'Inertia'"
                              : stage->vibrates() ? "'Frequency response'"
                                                  : "'Modes'") +
                             " of stage " +
                             std::to_string(stage - stages.begin() + 1));
  }


  void
  Parameters::check_laws() const
  {
    for (const PlyParameters &ply : laminate.plies)
      for (const MaterialParameters &material : materials)
        if (material.name == ply.material)
          {
            const std::vector<bool> rolling     = rolling_stages();
            double                  temperature = 0;
            for (unsigned int i = 0; i < stages.size(); ++i)
              {
                const Stage      &stage   = stages[i];
                const std::string section = "Stage " + std::to_string(i + 1);
                check_law(material, stage, section);
                if (material.relaxes() && rolling[i])
                  check_rolling_relaxation(material, stage, section);
                temperature = stage.temperature.value_or(temperature);
                if (material.relaxes() && (stage.duration > 0 || rolling[i]) &&
                    !(material.shift.factor(temperature) > 0))
                  throw InputError(section + "/Temperature",
                                   number_to_string(temperature),
                                   "the 'Temperature shift' of the material '" +
                                     material.name + "' has no value there");
              }
          }
  }


  void
  Parameters::check_heat() const
  {
    using Temperatures = RollingHeat::Parameters::Temperatures;
    if (heat.temperatures == Temperatures::given)
      return;
    const bool        coupled = heat.temperatures == Temperatures::coupled;
    const std::string value   = coupled ? "coupled" : "computed";
    const std::vector<bool> rolling = rolling_stages();
    if (std::none_of(
          rolling.begin(), rolling.end(), [](const bool i) { return i; }))
      throw InputError("Heat/Temperatures",
                       value,
                       "it must be 'given' without a stage in which the wheel "
                       "rolls");
    bool loses = false, shifts = false;
    for (const PlyParameters &ply : laminate.plies)
      for (const MaterialParameters &material : materials)
        if (material.name == ply.material)
          {
            // what conducts nothing cannot lose its heat
            if (!(material.of_ply().conductivity > 0))
              throw InputError(
                "Material " + material.name + "/Thermal conductivity",
                number_to_string(material.thermal_conductivity),
                "it must be positive with 'Heat/Temperatures = " + value + "'");
            loses = loses || material.relaxes() || material.loss_factor > 0;
            shifts =
              shifts || (material.relaxes() &&
                         material.shift.kind != Relaxation::Shift::Kind::none);
          }
    if (!loses)
      throw InputError("Heat/Temperatures",
                       value,
                       "it needs a material with 'Relaxation times' or a "
                       "'Loss factor'");
    // the temperatures would act on nothing
    if (coupled && !shifts)
      throw InputError("Heat/Temperatures",
                       value,
                       "it needs a material with a 'Temperature shift'");
    if (!(heat.inside.coefficient + heat.air.coefficient > 0))
      throw InputError("Heat/Air film",
                       number_to_string(heat.air.coefficient),
                       "it must be positive, or 'Inside film', for the heat to "
                       "leave the wall");
  }


  void
  Parameters::check_law(const MaterialParameters &material,
                        const Stage              &stage,
                        const std::string        &section) const
  {
    const std::string of_material = "with the material '" + material.name + "'";
    if (stage.from_prestress &&
        (material.is_hyperelastic() || material.relaxes()))
      throw InputError(section + "/Start from prestress",
                       "true",
                       "it must be 'false' " + of_material +
                         ", whose stresses depend on all that happened");
    if (stage.theory == StrainTheory::linear && material.is_hyperelastic())
      throw InputError(section + "/Strain theory",
                       "linear",
                       "it must be 'nonlinear' " + of_material +
                         ", whose law is not linear");
    if (!material.relaxes())
      return;
    if (stage.duration > 0 && (stage.control == ControlKind::arc_length ||
                               stage.control == ControlKind::displacement))
      throw InputError(section + "/Duration",
                       number_to_string(stage.duration),
                       "it must be 0 with 'Control = " + stage.control_name() +
                         "', where the loads may return");
    if (stage.duration > 0 && stage.theory == StrainTheory::linear)
      throw InputError(section + "/Duration",
                       number_to_string(stage.duration),
                       "it must be 0 with 'Strain theory = linear' " +
                         of_material + ", whose stresses relax");
  }


  void
  Parameters::check_rolling_relaxation(const MaterialParameters &material,
                                       const Stage              &stage,
                                       const std::string        &section) const
  {
    const std::string why =
      "where the wheel rolls or spins with the material '" + material.name +
      "', whose stresses relax";
    if (stage.transient_rolling)
      throw InputError(
        section + "/Transient rolling", "true", "it must be 'false' " + why);
    if (stage.duration > 0)
      throw InputError(section + "/Duration",
                       number_to_string(stage.duration),
                       "it must be 0 " + why +
                         ": that is the same at all times");
    if (stage.theory == StrainTheory::linear)
      throw InputError(
        section + "/Strain theory", "linear", "it must be 'nonlinear' " + why);
    if (stage.n_modes > 0)
      throw InputError(section + "/Modes",
                       std::to_string(stage.n_modes),
                       "it must be 0 " + why);
    if (!sensitivities.entries.empty())
      throw InputError("Sensitivities/Entries",
                       sensitivities.entries,
                       "it must be empty " + why);
  }


  void
  Parameters::check_edges() const
  {
    const auto is_closed = [](const Edge edge) {
      return edge == Edge::alpha_2_min || edge == Edge::alpha_2_max;
    };
    if (!supports.named_edges.empty())
      throw InputError("Supports/Edge supports",
                       supports.named_edges[0].text,
                       "only a mesh from a file ('Surface/Type = mesh') has "
                       "edges with such names; use the entries 'alpha_1 min' "
                       "and so on");
    for (const Edge edge : {Edge::alpha_2_min, Edge::alpha_2_max})
      if (mesh.closed &&
          (!supports.edges[static_cast<unsigned int>(edge)].empty() ||
           supports.cyclic[static_cast<unsigned int>(edge)]))
        throw InputError(
          "the section 'Supports' supports an edge of alpha_2, but the "
          "coordinate is closed ('Mesh/Closed in alpha_2') and has no edges.");
    const std::string why   = "the coordinate is closed and has no such edge";
    const auto        check = [&](const std::string &entry, const auto &loads) {
      for (const auto &load : loads)
        if (is_closed(parse_edge(entry, load.text, load.edge)) && mesh.closed)
          throw InputError(entry, load.text, why);
    };
    check("Loads/Edge forces", loads.edge_forces);
    check("Loads/Edge moments", loads.edge_moments);
  }


  namespace
  {
    /** Whether an angle, in radians, is one of 0 and 90 degrees. */
    bool
    is_along_a_line(const double angle)
    {
      // such plies are symmetric about the line, all others shear when they
      // stretch
      return std::abs(std::sin(2 * angle)) < 1e-6;
    }


    std::string
    in_quotes(const std::vector<std::string> &names)
    {
      std::string text;
      for (const std::string &name : names)
        text += (text.empty() ? "'" : ", '") + name + "'";
      return text;
    }
  } // namespace


  namespace
  {
    /** Whether the plies at a position are the same from the inside out as from
     * the outside in. */
    bool
    is_symmetric(const Layup &layup, const double alpha_1)
    {
      constexpr double tolerance = 1e-6;

      std::vector<const PlyDescription *> plies;
      for (const PlyDescription &ply : layup.get_plies())
        if (ply.begin <= alpha_1 && alpha_1 <= ply.end)
          plies.push_back(&ply);
      for (unsigned int i = 0; i < plies.size() / 2; ++i)
        {
          const PlyDescription &a = *plies[i];
          const PlyDescription &b = *plies[plies.size() - 1 - i];
          const double          t = a.thickness(alpha_1);
          if (a.material.name != b.material.name ||
              std::abs(b.thickness(alpha_1) - t) > tolerance * t ||
              // angles that differ by half a turn are the same
              (a.material.has_fibers &&
               std::abs(std::sin(a.angle(alpha_1) - b.angle(alpha_1))) >
                 tolerance))
            return false;
        }
      return true;
    }
  } // namespace


  std::vector<std::string>
  Parameters::warnings() const
  {
    std::vector<std::string> sentences = remarks_on_surface(surface);

    if (!tire_test.is_requested() &&
        !(tire_test.pressures.empty() && tire_test.slip_angles.empty() &&
          tire_test.slip_ratios.empty() && tire_test.ground_velocity == 0))
      sentences.push_back("Warning: the section 'Tire test' has no 'Loads', "
                          "so that there is no test.");

    // an error would be too much: a factor of 0 may be meant
    const auto rests = [this](const unsigned int factor) {
      return std::all_of(
        stages.begin(), stages.end(), [factor](const Stage &stage) {
          const auto &found = stage.motions_by_force;
          return factor_at(stage.factors, factor).value_or(0) == 0 &&
                 std::none_of(found.begin(),
                              found.end(),
                              [factor](const MotionByForce &motion) {
                                return motion.motion.factor == factor;
                              });
        });
    };
    const auto of_support_rests =
      [&rests](const std::vector<SupportCondition> &support) {
        return std::any_of(support.begin(),
                           support.end(),
                           [&](const SupportCondition &condition) {
                             return (condition.value != 0 ||
                                     condition.formula) &&
                                    rests(condition.factor);
                           });
      };
    std::vector<std::string> dead;
    if (std::any_of(
          loads.point_forces.begin(),
          loads.point_forces.end(),
          [&](const PointForce &item) { return rests(item.force.factor); }))
      dead.emplace_back("Loads/Point forces");
    if (std::any_of(
          loads.edge_forces.begin(),
          loads.edge_forces.end(),
          [&](const EdgeForce &item) { return rests(item.force.factor); }))
      dead.emplace_back("Loads/Edge forces");
    if (std::any_of(
          loads.edge_moments.begin(),
          loads.edge_moments.end(),
          [&](const EdgeMoment &moment) { return rests(moment.factor); }))
      dead.emplace_back("Loads/Edge moments");
    for (const auto face : {Resultants::inner, Resultants::outer})
      if (!loads.tractions[face].components.empty() &&
          rests(loads.tractions[face].factor))
        dead.emplace_back(face == Resultants::inner ? "Loads/Inner traction"
                                                    : "Loads/Outer traction");
    if (loads.area_force.norm() > 0 && rests(loads.factor_of_area_force))
      dead.emplace_back("Loads/Area force");
    if (std::any_of(
          supports.edges.begin(), supports.edges.end(), of_support_rests) ||
        std::any_of(supports.points.begin(),
                    supports.points.end(),
                    [&](const PointSupport &point) {
                      return of_support_rests(point.conditions);
                    }))
      dead.emplace_back("Supports");
    if (!dead.empty())
      sentences.push_back("No stage applies " + in_quotes(dead) +
                          ": the load factor stays 0; set 'Load "
                          "factor' in a stage.");

    for (const Edge edge : pressure.end_plates)
      {
        const auto  position = static_cast<unsigned int>(edge);
        const auto &support  = supports.edges[position];
        if (std::any_of(support.begin(), support.end(), [](const auto &c) {
              return c.formula.has_value();
            }))
          sentences.push_back("The pressure on the end plate of " +
                              edge_names[position] +
                              " acts along the axis; where the formulas of its "
                              "support tilt the plate, the part across the "
                              "axis is missing.");
      }

    if (const std::string warning = travel_beyond_supports(); !warning.empty())
      sentences.push_back(warning);

    std::vector<std::string> of_pressure;
    const PressureLoad       defaults;
    if (pressure.kind != defaults.kind)
      of_pressure.emplace_back("Loads/Pressure type");
    if (pressure.face != defaults.face)
      of_pressure.emplace_back("Loads/Pressure face");
    if (!pressure.is_uniform())
      of_pressure.emplace_back("Loads/Pressure distribution");
    if (!of_pressure.empty() &&
        std::none_of(stages.begin(), stages.end(), [](const Stage &stage) {
          return stage.pressure.value_or(0) != 0;
        }))
      sentences.push_back("No stage has a 'Pressure', to which " +
                          in_quotes(of_pressure) + " would apply.");

    // the plies on the surface, and the lines of the mesh across them
    const auto laid_out = [this]() {
      const std::shared_ptr<const ReferenceSurface> made =
        make_surface(surface);
      return std::make_pair(
        Layup(
          laminate, materials, plies_on_surface(made, ChartGrid(mesh, *made))),
        mesh.intervals[0].on(made->end(0)).lines());
    };
    if (surface.type == ReferenceSurface::Parameters::Type::plane)
      {
        const auto [layup, lines] = laid_out();
        if (!is_symmetric(layup, (lines[0] + lines[1]) / 2))
          sentences.push_back(
            "The plies are not symmetric about the middle of the wall: forces "
            "in its plane also bend it, and moments stretch it.");
      }

    if (!mesh.closed && supports.is_symmetric(2) && supports.is_symmetric(3))
      {
        const auto [layup, lines] = laid_out();
        std::string angled;
        for (const PlyDescription &ply : layup.get_plies())
          {
            if (!ply.material.has_fibers)
              continue;
            for (unsigned int i = 0; i + 1 < lines.size() && angled.empty();
                 ++i)
              {
                const double middle = (lines[i] + lines[i + 1]) / 2;
                if (ply.begin <= middle && middle <= ply.end &&
                    !is_along_a_line(ply.angle(middle)))
                  angled = ply.text;
              }
          }
        if (!angled.empty())
          sentences.push_back(
            "Both edges of alpha_2 have the support 'symmetry', but the ply '" +
            angled +
            "' is not symmetric about them: such plies also move along "
            "alpha_2, and the shell becomes too stiff. If the shell repeats "
            "along alpha_2, use 'cyclic' for both edges; else model the full "
            "turn.");
      }

    if (supports.is_cyclic() &&
        surface.type == ReferenceSurface::Parameters::Type::revolution)
      {
        const auto  &intervals = mesh.intervals[1].lines();
        const double sectors   = 360 / (intervals.back() - intervals.front());
        const bool   repeats =
          std::abs(sectors - std::round(sectors)) < 1e-6 * sectors;
        const bool same_all_around =
          loads.point_forces.empty() && supports.points.empty() &&
          std::none_of(stages.begin(), stages.end(), [](const Stage &stage) {
            return stage.contact;
          });
        if (!repeats && !same_all_around)
          sentences.push_back(
            "The edges of alpha_2 are 'cyclic', but the sector of " +
            number_to_string(intervals.back() - intervals.front()) +
            " degrees does not divide the full turn, so that contact, point "
            "forces and point supports cannot repeat in every sector.");
      }
    return sentences;
  }


  namespace
  {
    /** What of a mesh must be the same at a restart: its nodes, cells and
     * groups. */
    std::vector<Point<2>>
    pairs_of_mesh(const QuadrilateralMesh &mesh, const bool with_normals)
    {
      std::vector<Point<2>> pairs;
      const auto            add = [&pairs](const Tensor<1, 3> &x) {
        for (const Point<2> &pair : {Point<2>(x[0], x[1]), Point<2>(x[2], 0)})
          pairs.push_back(pair);
      };
      for (const Point<3> &x : mesh.nodes)
        add(x);
      // others follow from the nodes
      if (with_normals)
        for (const Tensor<1, 3> &normal : mesh.normals)
          add(normal);
      for (const auto &cell : mesh.cells)
        for (const unsigned int v : {0, 2})
          pairs.emplace_back(cell[v], cell[v + 1]);
      for (const QuadrilateralMesh::Group &group : mesh.groups)
        {
          for (const char c : group.name)
            pairs.emplace_back(static_cast<unsigned char>(c), -1);
          for (const unsigned int node : group.nodes)
            pairs.emplace_back(node, -2);
          for (const auto &side : group.sides)
            pairs.emplace_back(side[0], side[1]);
        }
      return pairs;
    }
  } // namespace


  PairsByEntry
  Parameters::named_pairs() const
  {
    // as pairs, which checkpoints keep: a restart compares what the files
    // contained
    PairsByEntry pairs;
    const auto   add_rows = [&](const std::string           &entry,
                              const std::vector<Point<3>> &rows) {
      for (const Point<3> &x : rows)
        for (const Point<2> &pair : {Point<2>(x[0], x[1]), Point<2>(x[2], 0)})
          pairs[entry].push_back(pair);
    };
    for (const Imperfection::Table &table : surface.imperfection.tables)
      add_rows("Surface/Imperfection/Tables, " + table.file.name, table.rows);
    for (const Imperfection::Series &series : surface.imperfection.series)
      for (const auto &term : series.terms.get_terms())
        for (const Point<2> &pair :
             {Point<2>(term.k, term.l), Point<2>(term.A, term.B)})
          pairs["Surface/Imperfection/Fourier series, " + series.file.name]
            .push_back(pair);
    if (!surface.points_file.name.empty())
      pairs["Surface/Spline/File"] = surface.points_file.pairs;
    if (surface.mesh.mesh)
      pairs["Surface/Mesh/File"] = pairs_of_mesh(
        *surface.mesh.mesh, surface.mesh.options.surface != nullptr);
    for (const TableFile &table : laminate.tables)
      pairs["Laminate/Tables, " + table.name] = table.file.pairs;
    for (unsigned int i = 0; i < stages.size(); ++i)
      for (const TableFile &table : stages[i].histories.tables)
        pairs["Stage " + std::to_string(i + 1) + "/History tables, " +
              table.name] = table.file.pairs;
    for (const MaterialParameters &material : materials)
      if (!material.cord_and_rubber.curve.name.empty())
        pairs["Material " + material.name + "/Cord curve"] =
          material.cord_and_rubber.curve.pairs;
    for (const BodyParameters &body : bodies)
      {
        const std::string section = "Body " + body.name + "/";
        if (!body.profile_file.empty())
          for (const auto &corner : body.profile)
            for (const Point<2> &pair :
                 {corner.point, Point<2>(corner.radius, 0)})
              pairs[section + "Profile file"].push_back(pair);
        add_rows(section + "Height file", body.heights);
      }
    return pairs;
  }


  std::vector<std::string>
  Parameters::input_files() const
  {
    std::vector<std::string> names{
      surface.points_file.name, surface.mesh.name, surface.mesh.geometry_file};
    for (const Imperfection::Table &table : surface.imperfection.tables)
      names.push_back(table.file.file_name);
    for (const Imperfection::Series &series : surface.imperfection.series)
      names.push_back(series.file.file_name);
    names.insert(names.end(), plies_files.begin(), plies_files.end());
    for (const TableFile &table : laminate.tables)
      names.push_back(table.file.name);
    for (const Stage &stage : stages)
      for (const TableFile &table : stage.histories.tables)
        names.push_back(table.file.name);
    for (const MaterialParameters &material : materials)
      names.push_back(material.cord_and_rubber.curve.name);
    for (const BodyParameters &body : bodies)
      {
        names.push_back(body.profile_file);
        names.push_back(body.height_file);
      }
    // entries without a file
    names.erase(std::remove(names.begin(), names.end(), ""), names.end());
    return names;
  }
} // namespace Biface
